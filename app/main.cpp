#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "algorithms/plugins.h"
#include "app/commands.h"
#include "base/errors.h"
#include "base/heap.h"
#include "base/spelling.h"
#include "knowledge/domain.h"

namespace partonomy::app {

void OntologyArguments::add_to(CLI::App& command, bool positional) {
    command.add_option(positional ? "ONTOLOGY" : "--ontology,-O", path, "the ontology, in any syntax of OWL 2")
        ->required();
    command.add_option("--import-dir", import_folders, "folder to search for imported ontologies (repeatable)");
    command.add_option("--plugin", plugins, "shared library with one more measurement (repeatable)");
    command.add_option("--diagram-nodes", limits.node_limit, "nodes that a diagram of configurations may have")
        ->capture_default_str();
    command
        .add_option("--diagram-steps", limits.step_limit, "million steps that making a diagram may take, 50 a second")
        ->capture_default_str();
    command.add_option("--diagram-seconds", limits.seconds_limit, "time that making a diagram may take; 0: no limit")
        ->capture_default_str();
    command.add_option("--diagram-mb", diagram_mb, "memory that a diagram may take")->capture_default_str();
}

void OntologyArguments::load_plugins() const {
    add_linked_algorithms();
    for (const std::string& plugin : plugins) load_plugin(plugin);
}

owl::Ontology OntologyArguments::read(bool whole_core) const {
    load_plugins();
    owl::LoadOptions options;
    options.whole_core = whole_core;
    options.import_folders.assign(import_folders.begin(), import_folders.end());
    return owl::load_ontology(path, options);
}

knowledge::CompileOptions OntologyArguments::compile_options() const {
    knowledge::CompileOptions options;
    options.diagram = limits;
    options.diagram.memory_limit = diagram_mb << 20;
    return options;
}

namespace {

/// What was mistyped: an unknown command, or an unknown option of a known one. Empty when neither.
std::string slip(const CLI::App& app, const std::vector<std::string>& words) {
    std::vector<std::string> commands;
    const CLI::App* chosen = nullptr;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        commands.push_back(command->get_name());
        if (!words.empty() && command->get_name() == words.front()) chosen = command;
    }
    if (words.empty() || words.front().starts_with('-')) return {};
    if (chosen == nullptr) return "\"" + words.front() + "\" is no command" + did_you_mean({words.front()}, commands);
    std::vector<std::string> options;
    for (const CLI::Option* option : chosen->get_options())
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (name.starts_with("--") && name != "--" && std::ranges::find(options, name) == options.end())
            return "\"" + name + "\" is no option of " + words.front() + did_you_mean({name}, options);
    }
    return {};
}

}  // namespace

/// A sentence about a command line that cannot be read, and where help is.
std::string explain_usage(const CLI::App& app, const std::vector<std::string>& words, const std::string& error) {
    const std::string mistyped = slip(app, words);
    const auto known = app.get_subcommands(
        [&](const CLI::App* command) { return !words.empty() && command->get_name() == words.front(); });
    return (mistyped.empty() ? error : mistyped) + (mistyped.ends_with('?') ? " See" : "; see") + " partonomy " +
           (known.empty() ? "" : words.front() + " ") + "--help";
}

}  // namespace partonomy::app

int main(int argc, char** argv) {
    partonomy::keep_freed_memory();
    using namespace partonomy::app;
    CLI::App app("Cuts 3D meshes into parts and names them, guided by an OWL ontology.", "partonomy");
    app.set_version_flag("--version", "partonomy " PARTONOMY_VERSION);
    app.require_subcommand(1);
    Run run;
    add_annotate_command(app, run);
    add_check_command(app, run);
    add_tree_command(app, run);
    add_explain_command(app, run);
    add_eval_command(app, run);
    add_export_command(app, run);
    add_catalogue_command(app, run);
    try {
        app.parse(argc, argv);
        const int code = run();
        for (const std::string& trouble : partonomy::plugin_troubles())
            std::fprintf(stderr, "partonomy: %s\n", trouble.c_str());
        // Everything is written: the system takes the memory back faster than the libraries' destructors give it back.
        std::fflush(nullptr);
        std::_Exit(code);
    } catch (const CLI::Success& asked_for_help) {
        return app.exit(asked_for_help);
    } catch (const CLI::Error& error) {
        const std::string sentence = explain_usage(app, {argv + 1, argv + argc}, error.what());
        std::fprintf(stderr, "partonomy: %s\n", sentence.c_str());
    } catch (const partonomy::Error& error) {
        std::fprintf(stderr, "partonomy: %s\n", error.what());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "partonomy: out of memory\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "partonomy: internal error, please report it: %s\n", error.what());
    }
    return bad_input;
}
