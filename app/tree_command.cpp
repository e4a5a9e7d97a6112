#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

#include "app/commands.h"
#include "base/errors.h"
#include "base/files.h"
#include "expert/annotate.h"
#include "knowledge/decision_tree.h"

namespace partonomy::app {
namespace {

struct Format {
    std::string_view extension;
    std::string (*write)(const knowledge::DecisionTree&, const knowledge::Domain&);
};
constexpr Format formats[]{{".json", knowledge::to_json},
                           {".dot", knowledge::to_dot},
                           {".svg", knowledge::to_svg},
                           {".html", knowledge::to_html}};

struct Arguments {
    OntologyArguments ontology;
    std::string output, criterion = "gain-per-cost", concept_name;
    std::size_t nodes = 20'000, depth = 0;
    bool every_configuration = false;
};

/// The space in which there is a concept of that local name; that of a region for no name.
const knowledge::Space& space_of(const knowledge::Domain& domain, const std::string& name) {
    if (name.empty()) return domain.regions;
    std::vector<const knowledge::Space*> spaces{&domain.regions};
    for (const knowledge::CompositeSpace& composite : domain.composites) spaces.push_back(&composite.space);
    spaces.push_back(&domain.objects());
    for (const knowledge::Space* space : spaces)
        for (const knowledge::Concept& concept_ : space->concepts)
            if (owl::local_name(concept_.iri) == name) return *space;
    throw UsageError(
        fmt::format("--concept {}: the ontology has no such concept of parts or objects; partonomy check "
                    "lists those that there are",
                    name));
}

int run_tree(const Arguments& arguments) {
    const std::string extension = std::filesystem::path(arguments.output).extension().string();
    const auto* format = std::ranges::find(formats, extension, &Format::extension);
    if (!arguments.output.empty() && format == std::end(formats))
        throw UsageError(fmt::format(
            "-o {}: cannot tell the format, use a name that ends in .json, .dot, .svg or .html", arguments.output));
    const auto start = std::chrono::steady_clock::now();
    const knowledge::Domain domain = arguments.ontology.load();
    const Catalogue catalogue = make_catalogue(domain);
    const knowledge::Space& space = space_of(domain, arguments.concept_name);
    const bool of_regions = &space == &domain.regions;
    knowledge::PlanOptions plan;
    plan.criterion = parse_criterion(arguments.criterion);
    plan.cost = [&](knowledge::Question question) -> std::optional<double> {
        if (!of_regions) return 1.0;  // answered by counting parts
        const ElementaryAlgorithm* algorithm = catalogue.find(Signature::is_a, question);
        if (!algorithm) algorithm = catalogue.find(Signature::related, question);
        return algorithm ? std::optional(algorithm->cost) : std::nullopt;
    };
    if (!arguments.every_configuration)
        for (int c = 0; c < static_cast<int>(space.concepts.size()); ++c) {
            const auto& concept_ = space.concepts[static_cast<std::size_t>(c)];
            if (concept_.provable && !concept_.iri.starts_with(owl::core_prefix)) plan.wanted.push_back(c);
        }
    std::function<std::optional<double>(knowledge::Question)> find_all;
    if (of_regions)
        find_all = [&](knowledge::Question question) -> std::optional<double> {
            return catalogue.cutting_cost(question, 0);
        };
    knowledge::TreeLimits limits;
    limits.nodes = arguments.nodes;
    limits.leave_open = true;
    if (arguments.depth > 0) limits.depth = arguments.depth;
    knowledge::DecisionTree tree = build_tree(space, plan, find_all, limits);
    // Where nothing that cuts tells anything, annotate cuts first and then asks of each part.
    const bool is_cut_first = of_regions && tree.nodes.size() == 1;
    if (is_cut_first) tree = build_tree(space, plan, {}, limits);
    const auto ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();

    if (arguments.output.empty())
        fmt::print("{}", to_dot(tree, domain));
    else
        write_file(arguments.output, format->write(tree, domain));
    fmt::print(stderr, "{}: {} configurations, {} nodes, depth {}, {:.1f} ms from file to tree\n",
               arguments.ontology.path, space.possible.count_text(), tree.nodes.size(), tree.depth(), ms);
    if (tree.nodes.size() == 1)
        fmt::print(stderr,
                   "{}: the tree asks nothing: what its concepts speak of is known beforehand, or no algorithm answers "
                   "it; partonomy check tells more\n",
                   arguments.ontology.path);
    else if (is_cut_first)
        fmt::print(stderr,
                   "{}: no concept speaks of a shape, so the mesh is cut into parts first, and this is asked of each\n",
                   arguments.ontology.path);
    if (!tree.is_whole())
        fmt::print(stderr,
                   "{}: this is not the whole tree: {} of its nodes are left open; raise --nodes or --depth to see "
                   "more, or leave out --every-configuration\n",
                   arguments.ontology.path,
                   std::ranges::count_if(tree.nodes, [](const auto& node) { return node.is_open; }));
    return recognised;
}

}  // namespace

void add_tree_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("tree", "the decision tree of an ontology's parts");
    arguments->ontology.add_to(command, true);
    command.add_option("-o,--output", arguments->output,
                       "tree.json, .dot, .svg or .html; DOT on standard output without it");
    command.add_option("--criterion", arguments->criterion, "dichotomy, entropy or gain-per-cost")
        ->capture_default_str();
    command.add_option("--concept", arguments->concept_name,
                       "the tree of this concept's layer: a composite part or the object; regions without it");
    command.add_option("--nodes", arguments->nodes, "nodes to expand at most; the rest is left open")
        ->capture_default_str();
    command.add_option("--depth", arguments->depth, "questions to expand below the root; 0: no limit")
        ->capture_default_str();
    command.add_flag("--every-configuration", arguments->every_configuration,
                     "ask until one configuration is left, not only until the part's name is known");
    command.callback([arguments, &run] { run = [arguments] { return run_tree(*arguments); }; });
}

}  // namespace partonomy::app
