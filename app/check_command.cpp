#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "base/errors.h"
#include "knowledge/lint.h"

namespace partonomy::app {
namespace {

using knowledge::Domain;
using knowledge::Finding;
using knowledge::FindingKind;
using knowledge::Space;
using nlohmann::ordered_json;

struct Arguments {
    OntologyArguments ontology;
    bool json = false, all = false;
};

std::vector<std::string> concepts_of(const Space& space) {
    std::vector<std::string> names;
    for (const knowledge::Concept& concept_ : space.concepts)
        if (!concept_.iri.starts_with(owl::core_prefix)) names.push_back(owl::local_name(concept_.iri));
    return names;
}

/// Counts that a double can hold are numbers, larger ones words.
ordered_json number(const std::string& digits) {
    if (digits.size() <= 15) return std::stoull(digits);
    return digits;
}

std::string words_of(const knowledge::Variable& variable) {
    if (variable.kind == knowledge::VariableKind::relation || variable.kind == knowledge::VariableKind::open)
        return to_manchester(*variable.part_class);
    if (variable.kind == knowledge::VariableKind::parts)
        return fmt::format("hasPart min {} {}", variable.threshold, to_manchester(*variable.part_class));
    return owl::local_name(variable.iri);
}

ordered_json space_as_json(const Space& space) {
    ordered_json variables = ordered_json::array();
    for (const knowledge::Variable& variable : space.variables)
        variables.push_back({{"variable", words_of(variable)}, {"values", variable.values}});
    return {{"concepts", concepts_of(space)},
            {"variables", variables},
            {"product", number(space.product_text())},
            {"consistent", number(space.all().count_text())},
            {"possible", number(space.possible.count_text())}};
}

void print_space(const std::string& title, const Space& space,
                 const char* what_is_counted = "combinations of answers satisfy the axioms") {
    fmt::print("{}\n  concepts: {}\n  questions about:", title, fmt::join(concepts_of(space), ", "));
    for (const knowledge::Variable& variable : space.variables)
        if (variable.part_class)
            fmt::print(" [{}]", words_of(variable));
        else
            fmt::print(" {} ({})", words_of(variable), fmt::join(variable.values, ", "));
    fmt::print("\n  configurations: {} of {} {}, {} of these without anything Incompatible\n", space.all().count_text(),
               space.product_text(), what_is_counted, space.possible.count_text());
}

std::string place_of(const owl::Source& source) {
    if (source.file.empty()) return {};
    return source.line > 0 ? fmt::format("{}:{}", source.file, source.line) : source.file;
}

ordered_json finding_as_json(const Finding& finding, const owl::Ontology& ontology) {
    std::vector<std::string> concepts;
    for (const owl::Iri& iri : finding.concepts) concepts.push_back(owl::local_name(iri));
    ordered_json causes = ordered_json::array();
    for (const auto& cause : finding.causes) {
        ordered_json axioms = ordered_json::array();
        for (const std::size_t i : cause) {
            const owl::Axiom& axiom = ontology.axioms[i];
            axioms.push_back(
                {{"axiom", to_manchester(axiom)}, {"file", axiom.source.file}, {"line", axiom.source.line}});
        }
        causes.push_back(std::move(axioms));
    }
    return {{"kind", to_text(finding.kind)}, {"severity", finding.is_wrong ? "wrong" : "remark"},
            {"concepts", concepts},          {"file", finding.where.file},
            {"line", finding.where.line},    {"what", finding.what},
            {"advice", finding.advice},      {"causes", causes}};
}

void print_finding(const Finding& finding, const owl::Ontology& ontology) {
    const std::string place = place_of(finding.where);
    fmt::print("{}: {}{}{}{}\n", finding.is_wrong ? "wrong" : "remark", place, place.empty() ? "" : ": ", finding.what,
               finding.advice.empty() ? "" : "; " + finding.advice);
    for (std::size_t i = 0; i < finding.causes.size(); ++i) {
        if (finding.causes.size() > 1) fmt::print("    reason {} of {}\n", i + 1, finding.causes.size());
        for (const std::size_t axiom : finding.causes[i])
            fmt::print("    {}: {}\n", place_of(ontology.axioms[axiom].source), to_manchester(ontology.axioms[axiom]));
    }
}

/// The ontology with its layers, unless it could not be compiled.
struct Checked {
    owl::Ontology ontology;
    std::optional<Domain> domain;
    std::vector<Finding> findings;
};

Checked look_at(const OntologyArguments& arguments) {
    Checked checked{arguments.read(), std::nullopt, {}};
    checked.findings = knowledge::unknown_terms(checked.ontology);
    const auto add = [&](std::vector<Finding> findings) {
        std::ranges::move(findings, std::back_inserter(checked.findings));
    };
    Catalogue catalogue;
    knowledge::LintOptions options;
    try {
        checked.domain = knowledge::compile(checked.ontology, arguments.compile_options());
        catalogue = make_catalogue(*checked.domain);
        options.can_answer = [&](knowledge::Question question) {
            return catalogue.find(Signature::is_a, question) != nullptr;
        };
    } catch (const OntologyError& error) {  // what can be answered is only known when this is mended
        add(knowledge::why_refused(checked.ontology, error.what()));
    }
    if (checked.domain) add(lint(*checked.domain, options));
    return checked;
}

/// All findings; of remarks about concepts that may hold together the first few stand for the rest, unless all are
/// asked for.
void print_findings(const Checked& checked, bool all) {
    constexpr std::ptrdiff_t shown = 3;
    const std::ptrdiff_t overlaps = std::ranges::count(checked.findings, FindingKind::overlapping, &Finding::kind);
    std::ptrdiff_t told = 0;
    for (const Finding& finding : checked.findings)
        if (finding.kind != FindingKind::overlapping || all || overlaps <= shown + 1 || told++ < shown)
            print_finding(finding, checked.ontology);
    if (told > shown)
        fmt::print("remark: {} more concepts may hold together with others; check --all lists them\n", told - shown);
}

ordered_json as_json(const Checked& checked, bool is_wrong) {
    ordered_json result = {{"ontology", checked.ontology.iri}};
    result["layers"] = ordered_json::object();
    result["composites"] = ordered_json::array();
    result["hierarchy"] = ordered_json::array();
    result["unsatisfiable"] = ordered_json::array();
    if (checked.domain) {
        result["layers"]["S1"] = space_as_json(checked.domain->regions);
        for (const knowledge::CompositeSpace& composite : checked.domain->composites) {
            result["composites"].push_back(space_as_json(composite.space));
            result["composites"].back()["layer"] = fmt::format("S{}", composite.layer);
        }
        result["layers"][fmt::format("S{}", checked.domain->object_layer())] = space_as_json(checked.domain->objects());
        for (const auto& [sub, super] : checked.domain->hierarchy())
            result["hierarchy"].push_back({owl::local_name(sub), owl::local_name(super)});
        for (const owl::Iri& iri : checked.domain->unsatisfiable())
            result["unsatisfiable"].push_back(owl::local_name(iri));
    }
    result["findings"] = ordered_json::array();
    for (const Finding& finding : checked.findings)
        result["findings"].push_back(finding_as_json(finding, checked.ontology));
    result["ok"] = !is_wrong;
    return result;
}

int run_check(const Arguments& arguments) {
    const Checked checked = look_at(arguments.ontology);
    const auto wrong = std::ranges::count_if(checked.findings, &Finding::is_wrong);
    if (arguments.json) {
        fmt::print("{}\n", as_json(checked, wrong > 0).dump(2));
        return wrong > 0 ? bad_input : recognised;
    }
    fmt::print("{}: {} axioms\n", checked.ontology.iri.empty() ? arguments.ontology.path : checked.ontology.iri,
               checked.ontology.axioms.size());
    if (checked.domain) {
        print_space("S1, parts", checked.domain->regions);
        for (const knowledge::CompositeSpace& composite : checked.domain->composites)
            print_space(fmt::format("S{}, composite parts", composite.layer), composite.space,
                        "combinations of answers make a composite part (there is none without the parts it asks for)");
        print_space(fmt::format("S{}, objects", checked.domain->object_layer()), checked.domain->objects());
    }
    print_findings(checked, arguments.all);
    if (wrong == 0)
        fmt::print("nothing wrong found\n");
    else
        fmt::print("{} wrong\n", wrong == 1 ? "1 thing is" : fmt::format("{} things are", wrong));
    return wrong > 0 ? bad_input : recognised;
}

}  // namespace

void add_check_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("check", "layers, concepts and faults of an ontology");
    arguments->ontology.add_to(command, true);
    command.add_flag("--all", arguments->all, "print every remark, however many");
    command.add_flag("--json", arguments->json, "print JSON, with the class hierarchy");
    command.callback([arguments, &run] { run = [arguments] { return run_check(*arguments); }; });
}

}  // namespace partonomy::app
