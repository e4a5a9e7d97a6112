/* docs/guide.md and then docs/guide-reference.md, followed to the letter. Blocks marked `omn` say what an expert has in
   the editor from then on (a frame replaces the earlier one of its name), with short names as Protégé shows them; here
   they are put together as the file that it would save. Blocks marked `console` are run in order; the lines below a
   command are to come out of it, one after another, and "…" stands for any lines. What is marked `json` is saved as
   said.json. Blocks marked `omn other` are of an ontology by itself, in which `check` finds nothing wrong. */

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <utility>

#include "app/run_program.h"
#include "base/files.h"
#include "examples/lamps.h"
#include "mesh/decode_image.h"
#include "mesh/write_off.h"
#include "owl/ontology.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;
const fs::path project = PARTONOMY_SOURCE_DIR;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// What the expert has in the editor.
class Editor {
public:
    Editor() {
        const owl::Ontology core = owl::parse_ontology(owl::core_ontology_text(), "core.ttl");
        for (const owl::Entity& entity : core.entities)
            if (entity.iri.starts_with(owl::core_prefix)) core_names_.insert(owl::local_name(entity.iri));
    }

    void type(const std::string& line) {
        if (line.starts_with("Class: ") || line.starts_with("ObjectProperty: ")) {
            const std::string name = line.substr(line.find(' ') + 1);
            EXPECT_FALSE(core_names_.contains(name)) << name << " is a name of core, too";
            const auto known = std::ranges::find(frames_, name, &Frame::name);
            current_ = static_cast<std::size_t>(known - frames_.begin());
            if (known == frames_.end()) frames_.push_back({});
            frames_[current_] = {name, {}};
        }
        if (!line.empty()) frames_.at(current_).lines.push_back(line);
    }

    [[nodiscard]] std::string saved() const {
        std::string text =
            "Prefix: : <https://w3id.org/partonomy/lamps#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
            "Prefix: owl: <http://www.w3.org/2002/07/owl#>\nPrefix: xsd: <http://www.w3.org/2001/XMLSchema#>\n\n"
            "Ontology: <https://w3id.org/partonomy/lamps>\n    Import: <https://w3id.org/partonomy/core>\n";
        for (const Frame& frame : frames_) {
            text += '\n';
            for (const std::string& line : frame.lines) text += in_full(line) + '\n';
        }
        return text;
    }

private:
    struct Frame {
        std::string name;
        std::vector<std::string> lines;
    };

    /// With the prefix that Protégé leaves out when it shows a name.
    [[nodiscard]] std::string in_full(const std::string& line) const {
        const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
        std::string text;
        bool is_quoted = false;
        for (std::size_t i = 0; i < line.size();) {
            std::size_t end = i;
            while (end < line.size() && is_letter(line[end])) ++end;
            const std::string word = line.substr(i, end - i);
            if (!word.empty() && !is_quoted && (end == line.size() || line[end] != ':')) {
                if (std::ranges::find(frames_, word, &Frame::name) != frames_.end()) text += ':';
                if (core_names_.contains(word)) text += "core:";
            }
            if (end == i) is_quoted ^= line[end++] == '"';
            text += line.substr(i, end - i);
            i = end;
        }
        return text;
    }

    std::set<std::string> core_names_;
    std::vector<Frame> frames_;
    std::size_t current_ = 0;
};

/// A line that ends in "…" tells the beginning.
bool is_told(const std::string& told, const std::string& line) {
    const std::string dots = "…";
    return told.ends_with(dots) ? line.starts_with(told.substr(0, told.size() - dots.size())) : line == told;
}

/// The lines come in this order; those that the guide leaves out are where it has "…".
void expect_output(const std::vector<std::string>& told, const std::string& output) {
    const std::vector<std::string> lines = lines_of(output);
    std::size_t at = 0;
    bool may_skip = false;
    for (const std::string& line : told) {
        if (line == "…") {
            may_skip = true;
            continue;
        }
        const std::size_t before = at;
        while (at < lines.size() && !is_told(line, lines[at])) ++at;
        ASSERT_LT(at, lines.size()) << "the guide says\n" << line << "\nbut it comes out\n" << output;
        EXPECT_TRUE(may_skip || at == before) << "left out before\n" << line << "\nin\n" << output;
        ++at;
        may_skip = false;
    }
}

void run_command(const std::string& command, const std::vector<std::string>& told, const fs::path& folder) {
    SCOPED_TRACE(command);
    std::istringstream in(command);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    ASSERT_GE(words.size(), 3U);
    ASSERT_EQ(words[0] + words[1], "$partonomy");
    const ProgramResult result = run_partonomy({words.begin() + 2, words.end()}, folder);
    EXPECT_TRUE(result.exit_code >= 0 && result.err.find("partonomy: ") == std::string::npos) << result.err;
    expect_output(told, result.out);
}

/// Follows both pages in this folder and returns what the expert has at its end.
std::string follow_guide(const TemporaryFolder& folder) {
    fs::create_directories(folder.path() / "lamps");
    for (const ExampleObject& lamp : lamps()) folder.write("lamps/" + lamp.name + ".off", to_off(lamp.mesh));
    Editor editor, other;
    std::string block, command;
    std::string said;
    std::vector<std::string> told;
    int commands = 0;
    const auto run = [&] {
        if (!command.empty()) run_command(command, told, folder.path());
        commands += !command.empty();
        command.clear();
        told.clear();
    };
    for (const std::string& line :
         lines_of(read_file(project / "docs/guide.md") + read_file(project / "docs/guide-reference.md"))) {
        if (line.starts_with("```")) {
            run();
            block = line.substr(3);
            folder.write("lamps.omn", editor.saved());
            if (!said.empty()) folder.write("said.json", std::exchange(said, {}));
        } else if (block == "omn") {
            editor.type(line);
        } else if (block == "json") {
            said += line + '\n';
        } else if (block == "omn other") {
            other.type(line);
        } else if (block == "console" && line.starts_with("$ ")) {
            run();
            command = line;
        } else if (block == "console") {
            told.push_back(line);
        }
    }
    EXPECT_GE(commands, 9);
    folder.write("other.omn", other.saved());
    run_command("$ partonomy check other.omn",
                {"…", "  concepts: Bowl, HammerHandle, Handle, Head, SpoonHandle", "…", "nothing wrong found"},
                folder.path());
    return editor.saved();
}

std::multiset<std::string> own_axioms(const owl::Ontology& ontology) {
    std::multiset<std::string> axioms;
    for (const owl::Axiom& axiom : ontology.axioms)
        if (axiom.source.file.find("core.ttl") == std::string::npos) axioms.insert(to_manchester(axiom));
    return axioms;
}

TEST(Guide, LeadsToWhatItSays) {
    const TemporaryFolder folder;
    const std::string saved = follow_guide(folder);
    const owl::Ontology made = owl::parse_ontology(saved, "lamps.omn"),
                        shipped = owl::load_ontology(project / "ontologies/lamps.omn");
    EXPECT_EQ(own_axioms(made), own_axioms(shipped));
    for (const char* name : {"Steady", "Tippy"}) {
        const owl::Iri iri = std::string("https://w3id.org/partonomy/lamps#") + name;
        std::set<std::string> knobs[2];
        int i = 0;
        for (const owl::Ontology* ontology : {&made, &shipped}) {
            for (const owl::Annotation& annotation : ontology->annotations.at(iri))
                knobs[i].insert(annotation.property + " " + annotation.literal.value);
            ++i;
        }
        EXPECT_EQ(knobs[0].size(), 3U);
        EXPECT_EQ(knobs[0], knobs[1]);
    }
    EXPECT_EQ(read_file(folder.path() / "tree.html").substr(0, 9), "<!doctype");
}

TEST(Guide, LampsAreWhatTheirMakerSays) {
    const TemporaryFolder folder;
    for (const ExampleObject& lamp : lamps()) {
        SCOPED_TRACE(lamp.name);
        folder.write(lamp.name + ".off", to_off(lamp.mesh));
        const ProgramResult result =
            run_partonomy({"annotate", lamp.name + ".off", "--ontology", (project / "ontologies/lamps.omn").string(),
                           "-o", "out", "--format", "labels"},
                          folder.path());
        EXPECT_EQ(result.exit_code, lamp.incompatibility.empty() && !lamp.object_class.empty() ? 0 : 2) << result.err;
        const std::string said = lamp.object_class.empty() ? "not recognised" : lamp.object_class;
        EXPECT_NE(result.out.find(": " + said), std::string::npos) << result.out;
        EXPECT_EQ(result.out.find("LampThatTips") != std::string::npos, !lamp.incompatibility.empty()) << result.out;
        const std::vector<std::string> labels = lines_of(read_file(folder.path() / "out" / lamp.name / "labels.txt"));
        ASSERT_EQ(labels.size(), lamp.labels.size());
        std::size_t same = 0;
        for (std::size_t i = 0; i < labels.size(); ++i) same += labels[i] == lamp.labels[i];
        // The top of a hood lies on its wall: some of the seam's faces may go to either.
        const bool has_hood = std::ranges::find(lamp.labels, "HoodTop") != lamp.labels.end();
        EXPECT_GE(same, has_hood ? labels.size() * 97 / 100 : labels.size());
    }
}

TEST(Guide, PictureIsTheProgramsOwn) {
    const TemporaryFolder folder;
    folder.write("floor-lamp.off", to_off(lamps().front().mesh));
    ASSERT_EQ(run_partonomy({"annotate", "floor-lamp.off", "--ontology", (project / "ontologies/lamps.omn").string(),
                             "-o", "out", "--format", "png"},
                            folder.path())
                  .exit_code,
              0);
    const auto decode = [](const fs::path& path) { return decode_image(read_file(path), path.string()); };
    const auto shown = decode(project / "docs/images/lamp.png"),
               drawn = decode(folder.path() / "out/floor-lamp/preview.png");
    ASSERT_EQ(shown.width, drawn.width);
    ASSERT_EQ(shown.height, drawn.height);
    EXPECT_EQ(shown.rgb, drawn.rgb) << "annotate a floor lamp with ontologies/lamps.omn and copy its preview.png";
}

}  // namespace
}  // namespace partonomy
