#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "app/commands.h"
#include "base/errors.h"
#include "knowledge/domain.h"

namespace partonomy::app {

void OntologyArguments::add_to(CLI::App& command, bool positional) {
    command.add_option(positional ? "ONTOLOGY" : "--ontology,-O", path, "the ontology, in any syntax of OWL 2")
        ->required();
    command.add_option("--import-dir", import_folders, "folder to search for imported ontologies (repeatable)");
    command.add_option("--diagram-nodes", limits.node_limit, "nodes that a diagram of configurations may have")
        ->capture_default_str();
    command.add_option("--diagram-seconds", limits.seconds_limit, "time that making a diagram may take")
        ->capture_default_str();
    command.add_option("--diagram-mb", diagram_mb, "memory that a diagram may take")->capture_default_str();
}

owl::Ontology OntologyArguments::read() const {
    owl::LoadOptions options;
    options.import_folders.assign(import_folders.begin(), import_folders.end());
    return owl::load_ontology(path, options);
}

knowledge::CompileOptions OntologyArguments::compile_options() const {
    knowledge::CompileOptions options;
    options.diagram = limits;
    options.diagram.memory_limit = diagram_mb << 20;
    return options;
}

}  // namespace partonomy::app

int main(int argc, char** argv) {
    // A short process gains nothing from giving memory back in between: one small object takes a fifth fewer page
    // faults.
    constexpr int megabyte = 1 << 20;
    ::mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
    ::mallopt(M_TRIM_THRESHOLD, 64 * megabyte);
    ::mallopt(M_TOP_PAD, 4 * megabyte);
    ::mallopt(M_ARENA_MAX, 1);  // threads work on what others made; heaps of their own are only more pages
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
        // Everything is written: the system takes the memory back faster than the libraries' destructors give it back.
        std::fflush(nullptr);
        std::_Exit(code);
    } catch (const CLI::Success& asked_for_help) {
        return app.exit(asked_for_help);
    } catch (const CLI::Error& error) {
        std::fprintf(stderr, "partonomy: %s; see partonomy --help\n", error.what());
    } catch (const partonomy::Error& error) {
        std::fprintf(stderr, "partonomy: %s\n", error.what());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "partonomy: out of memory\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "partonomy: internal error, please report it: %s\n", error.what());
    }
    return bad_input;
}
