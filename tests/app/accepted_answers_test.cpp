/* What a person says from the command line: annotate --answers. */

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/run_program.h"
#include "base/files.h"
#include "examples/objects.h"
#include "mesh/write_off.h"

namespace partonomy {
namespace {

using nlohmann::json;

/// A chair on a board among its feet, which furniture.ttl calls impossible, annotated without and with answers.
class StrangeChair {
public:
    StrangeChair() { folder.write("chair.off", to_off(paper_object("strange-object2").mesh)); }

    [[nodiscard]] ProgramResult annotate(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"annotate", "chair.off", "--ontology", furniture_path(),
                                           "-o",       "out",       "--format",   "json,trace"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_partonomy(arguments, folder.path());
    }
    [[nodiscard]] ProgramResult annotate_with(const std::string& answers) const {
        folder.write("said.json", answers);
        return annotate({"--answers", "said.json"});
    }
    [[nodiscard]] json annotation() const {
        return json::parse(read_file(folder.path() / "out/chair/annotation.json"));
    }

    TemporaryFolder folder;
};

json one(int part, const std::string& feature, const std::string& value) {
    return {{"part", part}, {"feature", feature}, {"value", value}};
}

TEST(AcceptedAnswers, CountMoreThanWhatWasMeasured) {
    const StrangeChair chair;
    ASSERT_EQ(chair.annotate().exit_code, 2);
    const json before = chair.annotation();
    const int board = before.at("diagnosis")[0].at("parts")[0];
    const ProgramResult result = chair.annotate_with(json::array({one(board, "Shape", "Stick")}).dump());
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    const json after = chair.annotation();
    EXPECT_EQ(after.at("object").at("classes"), json::array({"Chair"}));
    ASSERT_EQ(after.at("parts").size(), before.at("parts").size());
    const auto index = static_cast<std::size_t>(board) - 1;
    EXPECT_EQ(after.at("parts")[index].at("features").at("Shape"), "Stick");
    for (std::size_t i = 0; i < before.at("parts").size(); ++i) {
        if (i != index) {
            EXPECT_EQ(after.at("parts")[i], before.at("parts")[i]) << "nothing hung on it";
        }
    }
    int told = 0, accepted = 0;
    for (const json& entry : after.at("trace")) told += entry.at("kind") == "person";
    for (const json& answer : after.at("knowledge").at("answers")) accepted += answer.value("accepted", false);
    EXPECT_EQ(told, 1);
    EXPECT_EQ(accepted, 1);
    EXPECT_NE(read_file(chair.folder.path() / "out/chair/trace.txt").find("person"), std::string::npos);
    const ProgramResult why =
        run_partonomy({"explain", "out/chair", "--part", std::to_string(board)}, chair.folder.path());
    EXPECT_NE(why.out.find("a person said part " + std::to_string(board) + ": is it a stick: yes"), std::string::npos)
        << why.out;
}

TEST(AcceptedAnswers, AreFactsThatNoCorrectionTurnsRound) {
    const StrangeChair chair;
    ASSERT_EQ(chair.annotate().exit_code, 2);
    const json before = chair.annotation();
    json said = json::array();  // the cheapest way out, as the file itself has it, and the other way round
    const json& all = before.at("knowledge").at("answers");
    for (const json& i : before.at("diagnosis")[0].at("changes")[0].at("answers"))
        said.push_back(all[i.get<std::size_t>()]);
    EXPECT_EQ(chair.annotate_with(said.dump()).exit_code, 2);
    const json kept = chair.annotation();
    const json& diagnosis = kept.at("diagnosis")[0];
    EXPECT_FALSE(diagnosis.at("changes").empty());
    for (const json& change : diagnosis.at("changes"))
        for (const json& i : change.at("answers"))
            EXPECT_FALSE(kept.at("knowledge").at("answers")[i.get<std::size_t>()].value("accepted", false));
    EXPECT_TRUE(std::ranges::any_of(diagnosis.at("answers"), [](const json& text) {
        return text.get<std::string>().ends_with("(a person said so)");
    })) << diagnosis.at("answers");
    for (json& each : said) each["yes"] = !each.at("yes").get<bool>();
    EXPECT_EQ(chair.annotate_with(said.dump()).exit_code, 0);
    EXPECT_EQ(chair.annotate_with("[]").exit_code, 2) << "nothing said";
}

TEST(AcceptedAnswers, MistakesAreOneSentence) {
    const StrangeChair chair;
    const std::string stick = one(3, "Shape", "Stick").dump(), board = one(3, "Shape", "Board").dump();
    const std::vector<std::pair<std::string, std::string>> cases{
        {"[" + one(12, "Shape", "Stick").dump() + "]", "there is no part 12: there are parts 1 to 9"},
        {"[" + one(0, "Shape", "Stick").dump() + "]", "there is no part 0"},
        {"[" + one(3, "Shap", "Stick").dump() + "]",
         "\"Shap\" is no feature that this ontology asks for; did you mean \"Shape\"?"},
        {"[" + one(3, "https://w3id.org/partonomy/core#Orientatoin", "Up").dump() + "]",
         "did you mean \"Orientation\"?"},
        {"[" + one(3, "Bread", "Rye").dump() + "]", "\"Bread\" is no feature that this ontology asks for\n"},
        {"[" + one(3, "Shape", "Stik").dump() + "]", "Shape has no value \"Stik\": there are "},
        {"[" + one(3, "Shape", "Stik").dump() + "]", "; did you mean \"Stick\"?"},
        {"[" + one(3, "Leg", "yes").dump() + "]",
         "Leg is what follows from answers, and no question; say what makes it one: "},
        {"[" + stick + "," + board + "]", "part 3: Shape \"Board\": yes cannot hold together with what the file says"},
        {"[{\"part\": 3,\n\"feature\" \"Shape\"}]", "said.json:2: is no JSON"},
        {"", "said.json:1: is no JSON"},
        {stick, "said.json: is no list of answers; right would be [{"},
        {"[7]", "answer 1: is no {"},
        {"[" + stick + R"(, {"part": 3, "value": "Stick"}])", "answer 2: has no \"feature\""},
        {R"([{"part": "3", "feature": "Shape", "value": "Stick"}])", "\"part\" should be the number of a part"},
        {R"([{"part": 3, "feature": "Shape", "value": 1}])", "\"value\" should be a text"},
        {R"([{"part": 3, "feature": "Shape", "value": "Stick", "yes": 1}])", "\"yes\" should be true or false"},
        {R"([{"part": 3, "feature": "Shape", "vale": "Stick"}])",
         "\"vale\" means nothing here; did you mean \"value\"?"},
    };
    for (const auto& [answers, sentence] : cases) {
        SCOPED_TRACE(answers);
        const ProgramResult result = chair.annotate_with(answers);
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_TRUE(result.err.starts_with("partonomy: said.json")) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(sentence), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(chair.folder.path() / "out/chair")) << "half-written output";
    }
    ProgramResult result = chair.annotate({"--answers", "nowhere.json"});
    EXPECT_EQ(result.err, "partonomy: nowhere.json: no such file\n");
    chair.folder.write("said.json", "[]");
    chair.folder.write("other.off", read_file(chair.folder.path() / "chair.off"));
    result = chair.annotate({"--answers", "said.json", "--quiet", "other.off"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("tells of the parts of one mesh; annotate it alone"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace partonomy
