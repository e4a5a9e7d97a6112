#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"

namespace partonomy::app {
namespace {

using knowledge::Domain;
using knowledge::Space;
using nlohmann::ordered_json;

struct Arguments {
    OntologyArguments ontology;
    bool json = false;
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
    if (variable.kind == knowledge::VariableKind::relation) return to_manchester(*variable.part_class);
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

void print_space(const std::string& title, const Space& space) {
    fmt::print("{}\n  concepts: {}\n  questions about:", title, fmt::join(concepts_of(space), ", "));
    for (const knowledge::Variable& variable : space.variables)
        if (variable.part_class)
            fmt::print(" [{}]", words_of(variable));
        else
            fmt::print(" {} ({})", words_of(variable), fmt::join(variable.values, ", "));
    fmt::print("\n  configurations: {} of {} satisfy the axioms, {} are possible\n", space.all().count_text(),
               space.product_text(), space.possible.count_text());
}

int run_check(const Arguments& arguments) {
    const Domain domain = arguments.ontology.load();
    static_cast<void>(make_catalogue(domain));
    std::vector<std::string> unsatisfiable;
    for (const owl::Iri& iri : domain.unsatisfiable()) unsatisfiable.push_back(owl::local_name(iri));
    const bool is_wrong = !unsatisfiable.empty() || !domain.warnings.empty();
    if (arguments.json) {
        ordered_json hierarchy = ordered_json::array();
        for (const auto& [sub, super] : domain.hierarchy())
            hierarchy.push_back({owl::local_name(sub), owl::local_name(super)});
        ordered_json layers = {{"S1", space_as_json(domain.regions)}};
        ordered_json composites = ordered_json::array();
        for (const knowledge::CompositeSpace& composite : domain.composites) {
            composites.push_back(space_as_json(composite.space));
            composites.back()["layer"] = fmt::format("S{}", composite.layer);
        }
        layers[fmt::format("S{}", domain.object_layer())] = space_as_json(domain.objects);
        const ordered_json result = {{"ontology", domain.ontology.iri},
                                     {"layers", layers},
                                     {"composites", composites},
                                     {"hierarchy", hierarchy},
                                     {"unsatisfiable", unsatisfiable},
                                     {"warnings", domain.warnings},
                                     {"ok", !is_wrong}};
        fmt::print("{}\n", result.dump(2));
    } else {
        fmt::print("{}: {} axioms\n", domain.ontology.iri, domain.ontology.axioms.size());
        print_space("S1, parts", domain.regions);
        for (const knowledge::CompositeSpace& composite : domain.composites)
            print_space(fmt::format("S{}, composite parts", composite.layer), composite.space);
        print_space(fmt::format("S{}, objects", domain.object_layer()), domain.objects);
        for (const std::string& name : unsatisfiable) fmt::print("wrong: nothing can ever be a {}\n", name);
        for (const std::string& warning : domain.warnings) fmt::print("warning: {}\n", warning);
        if (!is_wrong) fmt::print("nothing wrong found\n");
    }
    return is_wrong ? bad_input : recognised;
}

}  // namespace

void add_check_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("check", "layers, concepts and faults of an ontology");
    arguments->ontology.add_to(command, true);
    command.add_flag("--json", arguments->json, "print JSON, with the class hierarchy");
    command.callback([arguments, &run] { run = [arguments] { return run_check(*arguments); }; });
}

}  // namespace partonomy::app
