#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/kept_annotation.h"
#include "base/errors.h"
#include "base/spelling.h"
#include "report/part_names.h"

namespace partonomy::app {
namespace {

using nlohmann::json;

struct Arguments {
    std::string folder;
    int part = 0;
    bool all = false;
    OntologyArguments ontology;
};

/// What stands in brackets at the end of a fact is about other parts.
bool mentions(const std::string& fact, const std::string& part) {
    const std::string text = fact.substr(0, fact.find(" ["));
    for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1))
        if (i + part.size() == text.size() || !std::isdigit(static_cast<unsigned char>(text[i + part.size()])))
            return true;
    return false;
}

std::string in_brackets(const std::string& numbers) { return numbers.empty() ? "" : " [" + numbers + "]"; }

/// " [l1/l2 10.5 (wanted >= 2)]" for the value of a range concept that a part was found to have; empty where a question
/// of the trace says so.
std::string what_was_measured(const json& annotation, const json& part, const std::string& feature, const json& value) {
    for (const json& answer : annotation.at("knowledge").at("answers")) {
        if (answer.at("part") != part || answer.at("value") != value || !answer.at("yes").get<bool>() ||
            owl::local_name(answer.at("feature").get<std::string>()) != feature)
            continue;
        const std::string measured = answer.value("measured", "");
        const std::string region = fmt::format("part {}", part.get<int>());
        const bool is_told = std::ranges::any_of(annotation.at("trace"), [&](const json& entry) {
            return entry.at("region") == region && entry.value("measured", "") == measured;
        });
        return is_told ? "" : in_brackets(measured);
    }
    return {};
}

void explain_part(const json& annotation, const json& part) {
    const std::string name = fmt::format("part {}", part.at("id").get<int>());
    const auto concepts = part.at("concepts").get<std::vector<std::string>>();
    fmt::print("{} is {} (score {:.3f}, {} faces)\n", name,
               concepts.empty() ? "nothing that the ontology names"
                                : with_article(fmt::format("{}", fmt::join(concepts, ", "))),
               part.at("score").get<double>(), part.at("faces").get<std::int64_t>());
    for (const auto& [feature, value] : part.at("features").items())
        fmt::print("  {}: {}{}\n", feature, value.get<std::string>(),
                   what_was_measured(annotation, part.at("id"), feature, value));
    if (part.contains("nearest")) {
        fmt::print("  it would be {}, but for\n", with_article(part.at("nearest").at("concept").get<std::string>()));
        for (const json& answer : part.at("nearest").at("refused_by"))
            fmt::print("    {}\n", answer.get<std::string>());
    }
    for (const json& entry : annotation.at("trace")) {
        std::vector<std::string> inferred;
        for (const json& text : entry.at("inferred"))
            if (mentions(text.get<std::string>(), name)) inferred.push_back(text.get<std::string>());
        if (entry.at("region") != name && inferred.empty()) continue;
        if (entry.at("kind") == "person")
            fmt::print("  a person said {}: {}{}{}\n", entry.at("question").get<std::string>(),
                       entry.at("answer").get<std::string>(), inferred.empty() ? "" : "; so ",
                       fmt::join(inferred, ", "));
        else
            fmt::print("  asked {}: {} (score {:.3f}){}{}{}\n", entry.at("question").get<std::string>(),
                       entry.at("answer").get<std::string>(), entry.at("score").get<double>(),
                       in_brackets(entry.value("measured", "")), inferred.empty() ? "" : "; so ",
                       fmt::join(inferred, ", "));
    }
}

/// What kept its name open, where a part's name was assumed.
void explain_open(const json& annotation, const json& part) {
    const std::string beginning = fmt::format("part {} is assumed", part.at("id").get<int>());
    for (const json& text : annotation.at("open_questions"))
        if (text.get<std::string>().starts_with(beginning)) fmt::print("  open: {}\n", text.get<std::string>());
}

/// What stayed open of the object: all that explain_open() does not print.
void explain_what_is_open(const json& annotation) {
    for (const json& text : annotation.at("open_questions"))
        if (!text.get<std::string>().starts_with("part ")) fmt::print("open: {}\n", text.get<std::string>());
}

/// "part 2", "parts 3, 4": each part that a count speaks of, or the pieces of each.
std::vector<std::string> bearers(const json& count) {
    std::vector<std::string> found;
    for (const json& each : count.at("bearers")) {
        const auto parts = each.get<std::vector<int>>();
        found.push_back(fmt::format("{} {}", parts.size() == 1 ? "part" : "parts", fmt::join(parts, ", ")));
    }
    return found;
}

/// Which parts meet what the definition of what is impossible asks for, and whether there are too many or too few of
/// some: only where it says nothing else of parts, or the number may be beside the point. Then the definition.
void print_in_short(const json& diagnosis) {
    const json counts = diagnosis.value("counts", json::array());
    const bool is_alone = counts.size() == 1 && diagnosis.value("counts_are_all", false);
    for (const json& each : counts) {
        const auto name = each.at("part").get<std::string>();
        const std::vector<std::string> all = bearers(each);
        const std::string which = all.empty() ? "" : fmt::format(" ({})", fmt::join(all, "; "));
        const std::size_t least = each.value("at_least", std::size_t{0});
        const std::size_t most = each.value("at_most", std::numeric_limits<std::size_t>::max());
        if (all.size() < least || all.size() > most) continue;
        if (is_alone && least == 0)
            fmt::print("  {} missing: {} {}{}, where at least {} is needed\n", most + 1 - all.size(), all.size(), name,
                       which, most + 1);
        else if (is_alone && least > 1 && !each.contains("at_most"))
            fmt::print("  {} too many: {} {}{}, where {} or more are impossible\n", all.size() - least + 1, all.size(),
                       name, which, least);
        else if (!all.empty())
            fmt::print("  its {}: {}\n", name, fmt::join(all, "; "));
    }
    const std::string beginning = diagnosis.at("concept").get<std::string>() + " EquivalentTo: ";
    for (const json& axiom : diagnosis.at("axioms"))
        if (const auto text = axiom.get<std::string>(); text.starts_with(beginning))
            fmt::print("  it is defined as {}\n", text.substr(beginning.size()));
}

void print_list(const char* title, const json& lines) {
    if (lines.empty()) return;
    fmt::print("  {}\n", title);
    for (const json& line : lines) fmt::print("    {}\n", line.is_string() ? line.get<std::string>() : line.dump());
}

/// What a rule rests on, and then what makes the object a case of it.
void print_answers(const json& diagnosis) {
    const json none = json::array();
    const json& answers = diagnosis.contains("answers") ? diagnosis.at("answers") : none;
    const json& given = diagnosis.contains("given") ? diagnosis.at("given").at("concepts") : none;
    const std::size_t count = given.empty() ? 0 : diagnosis.at("given").at("answers").get<std::size_t>();
    const auto end = answers.end() - static_cast<std::ptrdiff_t>(std::min(count, answers.size()));
    print_list("answers that lead to it", json(std::vector<json>(answers.begin(), end)));
    std::vector<std::string> names;
    for (const json& each : given) names.push_back(with_article(each.get<std::string>()));
    print_list(fmt::format("answers by which it is {}", fmt::join(names, " and ")).c_str(),
               json(std::vector<json>(end, answers.end())));
}

/// What leaves the object all that it is, and what does not.
void print_corrections(const json& diagnosis) {
    json repairs = json::array(), others = json::array();
    const json& texts = diagnosis.at("corrections");
    for (std::size_t i = 0; i < texts.size(); ++i)
        (diagnosis.at("changes").at(i).contains("lost") ? others : repairs).push_back(texts[i]);
    print_list("what would repair it", repairs);
    print_list("what would make it something else", others);
}

/// The parts that come nearest to one that is missing.
void print_near_parts(const json& diagnosis) {
    for (const json& near : diagnosis.value("nearest", json::array())) {
        fmt::print("  part {} would be {}, but for\n", near.at("part").get<int>(),
                   with_article(near.at("concept").get<std::string>()));
        for (const json& answer : near.at("refused_by")) fmt::print("    {}\n", answer.get<std::string>());
    }
}

/// Every minimal explanation of every diagnosis, from the answers that the annotation keeps.
void print_all_explanations(const Arguments& arguments, const json& annotation) {
    const knowledge::Domain domain = load_same_ontology(arguments.ontology, annotation);
    const std::vector<LearnedAnswer> answers = answers_of(annotation);
    const knowledge::Knowledge knowledge = knowledge_of(domain, annotation);
    for (const json& diagnosis : annotation.at("diagnosis")) {
        const auto name = diagnosis.at("concept").get<std::string>();
        owl::Iri iri;
        int region = -1;
        std::vector<const knowledge::Space*> spaces{&domain.objects()};
        for (const knowledge::CompositeSpace& composite : domain.composites) spaces.push_back(&composite.space);
        spaces.push_back(&domain.regions);
        for (const knowledge::Space* space : spaces)
            for (const knowledge::Concept& concept_ : space->concepts)
                if (iri.empty() && owl::local_name(concept_.iri) == name && concept_.incompatible) {
                    iri = concept_.iri;
                    if (space == &domain.regions) region = diagnosis.at("parts").at(0).get<int>() - 1;
                }
        const knowledge::Explanations found = all_explanations(domain, knowledge, iri, region);
        for (std::size_t i = 0; i < found.sets.size(); ++i) {
            fmt::print("{}: explanation {} of {}{}\n", name, i + 1, found.sets.size(),
                       found.is_complete ? "" : " or more");
            for (const std::size_t a : found.sets[i].answers)
                fmt::print("    {}\n", answer_in_words(domain, knowledge.answers[a], answers[a]));
            if (found.sets[i].needs_completeness) fmt::print("    {}\n", no_other_parts);
            for (const std::size_t a : found.sets[i].axioms)
                fmt::print("    {}\n", axiom_in_words(domain.ontology.axioms[a]));
        }
    }
}

/// Everything about what is impossible.
void explain_diagnoses(const json& annotation) {
    for (const json& diagnosis : annotation.at("diagnosis")) {
        const auto parts = diagnosis.at("parts").get<std::vector<int>>();
        fmt::print("impossible: {}, because of {}\n", diagnosis.at("concept").get<std::string>(),
                   parts.empty() ? "the object as a whole" : fmt::format("part {}", fmt::join(parts, ", ")));
        if (diagnosis.contains("comment")) fmt::print("  {}\n", diagnosis.at("comment").get<std::string>());
        print_in_short(diagnosis);
        print_near_parts(diagnosis);
        print_answers(diagnosis);
        print_corrections(diagnosis);
        print_list("axioms that lead to it", diagnosis.at("axioms"));
    }
}

int run_explain(const Arguments& arguments) {
    const json annotation = load_annotation(arguments.folder);
    try {
        const json& object = annotation.at("object");
        const auto classes = object.at("classes").get<std::vector<std::string>>();
        if (arguments.part == 0)
            fmt::print("the object is {}, {} (score {:.3f})\n",
                       classes.empty() ? "not recognised" : fmt::format("{}", fmt::join(classes, ", ")),
                       !object.at("consistent").get<bool>()                          ? "incompatible"
                       : object.value("perhaps", std::vector<std::string>{}).empty() ? "consistent"
                                                                                     : "consistent as far as is known",
                       object.at("score").get<double>());
        if (arguments.part == 0 && object.contains("nearest"))
            for (const json& near : object.at("nearest"))
                fmt::print("  near: {}\n", in_words({near.at("class"), near.at("lacks").get<std::vector<std::string>>(),
                                                     near.at("too_many").get<std::vector<std::string>>()}));
        explain_diagnoses(annotation);
        bool is_found = false;
        for (const json& part : annotation.at("parts"))
            if (arguments.part == 0 || part.at("id") == arguments.part) {
                explain_part(annotation, part);
                explain_open(annotation, part);
                is_found = true;
            }
        if (arguments.part != 0 && !is_found)
            throw UsageError(
                fmt::format("--part {}: there are parts 1 to {}", arguments.part, annotation.at("parts").size()));
        for (const json& composite : annotation.at("composites")) {
            const auto parts = composite.at("parts").get<std::vector<int>>();
            if (arguments.part == 0 || std::ranges::find(parts, arguments.part) != parts.end())
                fmt::print("part{} {} {} {}\n", parts.size() > 1 ? "s" : "", fmt::join(parts, ", "),
                           parts.size() > 1 ? "together are" : "is as a whole",
                           fmt::join(composite.at("concepts").get<std::vector<std::string>>(), ", "));
        }
        if (arguments.part == 0) explain_what_is_open(annotation);
        if (arguments.all) print_all_explanations(arguments, annotation);
        return object.at("consistent").get<bool>() ? recognised : incompatible;
    } catch (const json::exception& error) {
        throw UsageError(at(annotation_path(arguments.folder).string(), 0,
                            std::string("is not a complete annotation: ") + error.what()));
    }
}

}  // namespace

void add_explain_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("explain", "why a part has its name, or why an object is impossible");
    command.add_option("DIR", arguments->folder, "folder of one annotated mesh, or the annotation.json in it")
        ->required();
    command.add_option("--part", arguments->part, "only this part");
    command.add_flag("--all", arguments->all, "every minimal explanation of what is impossible");
    command.add_option("--ontology,-O", arguments->ontology.path, "for --all: where the ontology is now");
    command.add_option("--import-dir", arguments->ontology.import_folders,
                       "for --all: folder to search for imported ontologies (repeatable)");
    command.callback([arguments, &run] { run = [arguments] { return run_explain(*arguments); }; });
}

}  // namespace partonomy::app
