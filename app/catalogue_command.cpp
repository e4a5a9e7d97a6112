#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "algorithms/relations.h"
#include "app/commands.h"
#include "base/json_text.h"

namespace partonomy::app {

namespace {

const char* word_of(Signature signature) {
    switch (signature) {
        case Signature::find_all:
            return "SF";
        case Signature::is_a:
            return "SI";
        case Signature::related:
            return "T";
        default:
            return "TF";
    }
}

const char* word_of(Origin origin) { return origin == Origin::own ? "own" : "derived"; }

/// Numbers that axioms compare, as core has them: the property and what it measures.
std::vector<std::pair<std::string, std::string>> number_properties() {
    const owl::Ontology core = owl::parse_ontology(owl::core_ontology_text(), "core.ttl");
    std::vector<std::pair<std::string, std::string>> numbers;
    for (const owl::Entity& entity : core.entities) {
        const auto annotations = core.annotations.find(entity.iri);
        if (entity.kind != owl::EntityKind::data_property || annotations == core.annotations.end()) continue;
        for (const owl::Annotation& annotation : annotations->second)
            if (owl::local_name(annotation.property) == "measure")
                numbers.emplace_back(owl::local_name(entity.iri), annotation.literal.value);
    }
    return numbers;
}

/// What the ontology asks and no algorithm answers: it stays open.
std::vector<std::string> unanswered(const knowledge::Domain& domain, const Catalogue& catalogue) {
    std::vector<std::string> names;
    for (int v = 0; v < static_cast<int>(domain.regions.variables.size()); ++v) {
        const knowledge::Variable& variable = domain.regions.variables[static_cast<std::size_t>(v)];
        const bool is_relation = variable.kind == knowledge::VariableKind::relation;
        const bool is_asked = is_relation || variable.kind == knowledge::VariableKind::range ||
                              variable.kind == knowledge::VariableKind::number;
        if (!is_asked || std::ranges::any_of(catalogue.algorithms, [&](const ElementaryAlgorithm& algorithm) {
                return algorithm.question.variable == v;
            }))
            continue;
        names.push_back(is_relation ? to_manchester(*variable.part_class) : owl::local_name(variable.iri));
    }
    return names;
}

void print_text(const knowledge::Domain& domain, const Catalogue& catalogue) {
    fmt::print("{:<9} {:<18} {:>5}  {:<7}  {}\n", "signature", "concept", "cost", "origin", "how");
    for (const ElementaryAlgorithm& algorithm : catalogue.algorithms)
        fmt::print("{:<9} {:<18} {:>5}  {:<7}  {}{}\n", word_of(algorithm.signature), algorithm.name, algorithm.cost,
                   word_of(algorithm.origin), algorithm.method, algorithm.needs_metres ? " (needs a unit)" : "");
    for (const std::string& name : unanswered(domain, catalogue))
        fmt::print("{:<9} {:<18} {:>5}  {:<7}  it names no measure, so it stays open; partonomy check tells more\n",
                   "none", name, "-", "-");
    fmt::print("\n{:<16} {:<8} {}\n", "measure", "unit", "what it is");
    for (const Measure& measure : all_measures())
        fmt::print("{:<16} {:<8} {}\n", measure.name, measure.unit, measure.description);
    fmt::print("\n{:<16} {}\n", "number", "what it measures, as in: height some xsd:double[>= 0.4]");
    for (const auto& [property, measure] : number_properties()) fmt::print("{:<16} {}\n", property, measure);
    fmt::print("\n{:<18} {:<8} {:<8} {}\n", "between regions", "regions", "unit", "what it is");
    for (const RelationMeasure& measure : all_relation_measures())
        fmt::print("{:<18} {:<8} {:<8} {}\n", measure.name, measure.arity, measure.unit, measure.description);
}

void print_json(const knowledge::Domain& domain, const Catalogue& catalogue) {
    JsonText json(2);
    json.object().array("algorithms");
    for (const ElementaryAlgorithm& algorithm : catalogue.algorithms)
        json.object_in_line()
            .member("signature", word_of(algorithm.signature))
            .member("concept", algorithm.name)
            .member("method", algorithm.method)
            .member("cost", algorithm.cost)
            .member("origin", word_of(algorithm.origin))
            .member("needs_unit", algorithm.needs_metres)
            .end();
    json.end().member("unanswered", unanswered(domain, catalogue)).array("measures");
    for (const Measure& measure : all_measures())
        json.object_in_line()
            .member("name", measure.name)
            .member("unit", measure.unit)
            .member("description", measure.description)
            .end();
    json.end().array("numbers");
    for (const auto& [property, measure] : number_properties())
        json.object_in_line().member("property", property).member("measure", measure).end();
    json.end().array("relation_measures");
    for (const RelationMeasure& measure : all_relation_measures())
        json.object_in_line()
            .member("name", measure.name)
            .member("regions", measure.arity)
            .member("unit", measure.unit)
            .member("description", measure.description)
            .end();
    json.end().end();
    fmt::print("{}\n", json.text());
}
}  // namespace

void add_catalogue_command(CLI::App& app, Run& run) {
    struct Arguments {
        OntologyArguments ontology;
        bool json = false;
    };
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command =
        *app.add_subcommand("catalogue", "every elementary algorithm, its signature and cost; every measure");
    arguments->ontology.add_to(command, true);
    command.get_option("ONTOLOGY")->required(false)->description("the ontology; the built-in core without it");
    command.add_option("--ontology,-O", arguments->ontology.path, "the same, as annotate takes it");
    command.add_flag("--json", arguments->json, "print JSON");
    command.callback([arguments, &run] {
        run = [arguments] {
            arguments->ontology.load_plugins();
            const knowledge::Domain domain =
                arguments->ontology.path.empty() ? make_core_domain() : arguments->ontology.load();
            const Catalogue catalogue = make_catalogue(domain);
            if (arguments->json)
                print_json(domain, catalogue);
            else
                print_text(domain, catalogue);
            return static_cast<int>(recognised);
        };
    });
}

}  // namespace partonomy::app
