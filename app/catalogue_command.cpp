#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "algorithms/relations.h"
#include "app/commands.h"

namespace partonomy::app {

namespace {

const char* word_of(Signature signature) {
    return signature == Signature::find_all ? "SF" : signature == Signature::is_a ? "SI" : "T";
}

}  // namespace

void add_catalogue_command(CLI::App& app, Run& run) {
    auto ontology = std::make_shared<OntologyArguments>();
    CLI::App& command =
        *app.add_subcommand("catalogue", "every elementary algorithm, its signature and cost; every measure");
    ontology->add_to(command, true);
    command.callback([ontology, &run] {
        run = [ontology] {
            const knowledge::Domain domain = ontology->load();
            fmt::print("{:<9} {:<18} {:>5}  {:<7}  {}\n", "signature", "concept", "cost", "origin", "how");
            for (const ElementaryAlgorithm& algorithm : make_catalogue(domain).algorithms)
                fmt::print("{:<9} {:<18} {:>5}  {:<7}  {}{}\n", word_of(algorithm.signature), algorithm.name,
                           algorithm.cost, algorithm.origin == Origin::own ? "own" : "derived", algorithm.method,
                           algorithm.needs_metres ? " (needs a unit)" : "");
            fmt::print("\n{:<16} {:<8} {}\n", "measure", "unit", "what it is");
            for (const Measure& measure : all_measures())
                fmt::print("{:<16} {:<8} {}\n", measure.name, measure.unit, measure.description);
            fmt::print("\n{:<18} {:<8} {:<8} {}\n", "between regions", "regions", "unit", "what it is");
            for (const RelationMeasure& measure : all_relation_measures())
                fmt::print("{:<18} {:<8} {:<8} {}\n", measure.name, measure.arity, measure.unit, measure.description);
            return static_cast<int>(recognised);
        };
    });
}

}  // namespace partonomy::app
