#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "base/errors.h"
#include "base/files.h"
#include "knowledge/closed_world.h"
#include "owl/write.h"

namespace partonomy::app {
namespace {

struct Arguments {
    OntologyArguments ontology;
    std::string output, format;
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

int run_export(const Arguments& arguments) {
    const bool functional = is_functional(arguments);
    owl::Ontology ontology = arguments.ontology.read();
    if (arguments.closed) {
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
                     "add what closes the world: the named individuals are all there are, and pairwise different");
    command.callback([arguments, &run] { run = [arguments] { return run_export(*arguments); }; });
}

}  // namespace partonomy::app
