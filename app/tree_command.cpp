#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "base/errors.h"
#include "base/files.h"
#include "expert/annotate.h"
#include "knowledge/decision_tree.h"

namespace partonomy::app {
namespace {

struct Arguments {
    OntologyArguments ontology;
    std::string output, criterion = "dichotomy";
    bool every_configuration = false;
};

int run_tree(const Arguments& arguments) {
    const std::string extension = std::filesystem::path(arguments.output).extension().string();
    if (!arguments.output.empty() && extension != ".json" && extension != ".dot")
        throw UsageError(
            fmt::format("-o {}: cannot tell the format, use a name that ends in .json or .dot", arguments.output));
    const auto start = std::chrono::steady_clock::now();
    const knowledge::Domain domain = arguments.ontology.load();
    const Catalogue catalogue = make_catalogue(domain);
    knowledge::PlanOptions plan;
    plan.criterion = parse_criterion(arguments.criterion);
    plan.cost = [&](knowledge::Question question) -> std::optional<double> {
        const ElementaryAlgorithm* algorithm = catalogue.find(Signature::is_a, question);
        return algorithm ? std::optional(algorithm->cost) : std::nullopt;
    };
    if (!arguments.every_configuration)
        for (int c = 0; c < static_cast<int>(domain.regions.concepts.size()); ++c) {
            const auto& concept_ = domain.regions.concepts[static_cast<std::size_t>(c)];
            if (concept_.provable && !concept_.iri.starts_with(owl::core_prefix)) plan.wanted.push_back(c);
        }
    const auto find_all = [&](knowledge::Question question) -> std::optional<double> {
        const ElementaryAlgorithm* algorithm = catalogue.find(Signature::find_all, question);
        return algorithm ? std::optional(algorithm->cost) : std::nullopt;
    };
    const knowledge::DecisionTree tree = build_tree(domain.regions, plan, find_all);
    const auto ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();

    if (arguments.output.empty())
        fmt::print("{}", to_dot(tree, domain));
    else
        write_file(arguments.output, extension == ".json" ? to_json(tree, domain) : to_dot(tree, domain));
    fmt::print(stderr, "{}: {} configurations, {} nodes, depth {}, {:.1f} ms from file to tree\n",
               arguments.ontology.path, domain.regions.possible.count(), tree.nodes.size(), tree.depth(), ms);
    return recognised;
}

}  // namespace

void add_tree_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("tree", "the decision tree of an ontology's parts");
    arguments->ontology.add_to(command, true);
    command.add_option("-o,--output", arguments->output, "tree.json or tree.dot; DOT on standard output without it");
    command.add_option("--criterion", arguments->criterion, "dichotomy or gain-per-cost")->capture_default_str();
    command.add_flag("--every-configuration", arguments->every_configuration,
                     "ask until one configuration is left, not only until the part's name is known");
    command.callback([arguments, &run] { run = [arguments] { return run_tree(*arguments); }; });
}

}  // namespace partonomy::app
