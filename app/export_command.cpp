#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/kept_annotation.h"
#include "base/errors.h"
#include "base/files.h"
#include "knowledge/mesh_world.h"
#include "owl/write.h"

namespace partonomy::app {
namespace {

struct Arguments {
    OntologyArguments ontology;
    std::string output, format, used_ontology;
    bool merge_imports = false, closed = false;
};

bool is_functional(const Arguments& arguments) {
    if (!arguments.format.empty()) return arguments.format == "functional";
    const std::string extension = std::filesystem::path(arguments.output).extension().string();
    if (arguments.output.empty() || extension == ".ttl") return false;
    if (extension == ".ofn" || extension == ".fss") return true;
    throw UsageError(fmt::format("-o {}: cannot tell the format, give --format or use a name that ends in .ttl or .ofn",
                                 arguments.output));
}

/// The mesh that was annotated in this folder as a closed knowledge base: object, parts, feature values, answers.
owl::Ontology closed_mesh(const Arguments& arguments) {
    const std::string& folder = arguments.ontology.path;
    const nlohmann::json annotation = load_annotation(folder);
    OntologyArguments used = arguments.ontology;
    used.path = arguments.used_ontology;
    try {
        const knowledge::Domain domain = load_same_ontology(used, annotation);
        const knowledge::Knowledge known = knowledge_of(domain, annotation);
        const auto composites = knowledge::composites_for_world(domain, known);
        if (!composites)
            throw UsageError(folder +
                             ": which composite parts there are is not certain, since features of regions that they "
                             "could be made of are open, so there is no world to close; partonomy explain shows them");
        return knowledge::closed_ontology(knowledge::make_mesh_world(domain, known, *composites).world);
    } catch (const nlohmann::json::exception& error) {
        throw UsageError(
            at(folder + "/annotation.json", 0, std::string("is not a complete annotation: ") + error.what()));
    }
}

int run_export(const Arguments& arguments) {
    const bool functional = is_functional(arguments);
    const bool of_mesh = std::filesystem::is_directory(arguments.ontology.path);
    if (of_mesh && !arguments.closed)
        throw UsageError(arguments.ontology.path +
                         ": is a folder; --closed writes the closed world of the mesh that was "
                         "annotated there");
    owl::Ontology ontology = of_mesh ? closed_mesh(arguments) : arguments.ontology.read();
    if (arguments.closed && !of_mesh) {
        std::vector<owl::Iri> individuals = knowledge::individuals_of(ontology);
        if (individuals.empty())
            throw UsageError(
                arguments.ontology.path +
                " names no individual, so there is no world to close; --closed is for knowledge bases about "
                "named things");
        ontology = knowledge::closed_ontology({std::move(ontology), std::move(individuals)});
    }
    const owl::WriteOptions options = {.merge_imports = arguments.merge_imports || arguments.closed};
    const std::string text = functional ? write_functional(ontology, options) : write_turtle(ontology, options);
    if (arguments.output.empty())
        fmt::print("{}", text);
    else
        write_file(arguments.output, text);
    return recognised;
}

}  // namespace

void add_export_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("export", "an ontology as Turtle or in functional syntax");
    arguments->ontology.add_to(command, true);
    command.add_option("-o,--output", arguments->output, "file to write; standard output without it");
    command
        .add_option("--format", arguments->format, "ttl or functional; without it, what the file's name says, else ttl")
        ->check(CLI::IsMember({"ttl", "functional"}));
    command.add_flag("--merge-imports", arguments->merge_imports,
                     "one self-contained file with the axioms of all imports, instead of owl:imports");
    command.add_flag("--closed", arguments->closed,
                     "add what closes the world: the named individuals are all there are, and pairwise different; of "
                     "the folder of an annotated mesh: its object, parts, answers and what closes them");
    command.add_option("--ontology,-O", arguments->used_ontology,
                       "for the folder of a mesh: where the ontology is now that it was annotated with");
    command.callback([arguments, &run] { run = [arguments] { return run_export(*arguments); }; });
}

}  // namespace partonomy::app
