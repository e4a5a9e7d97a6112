#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "algorithms/catalogue.h"
#include "knowledge/domain.h"

namespace CLI {
class App;
}

namespace partonomy::app {

/// Exit codes that users script against.
enum ExitCode { recognised = 0, bad_input = 1, incompatible = 2 };

/// Each adds its subcommand to the command line; when the user chose it, `run` is set to what does the work and returns
/// the exit code. Errors leave as exceptions of base/errors.h.
using Run = std::function<int()>;
void add_annotate_command(CLI::App& app, Run& run);
void add_check_command(CLI::App& app, Run& run);
void add_tree_command(CLI::App& app, Run& run);
void add_eval_command(CLI::App& app, Run& run);
void add_explain_command(CLI::App& app, Run& run);
void add_export_command(CLI::App& app, Run& run);
void add_catalogue_command(CLI::App& app, Run& run);

/// --ontology, --import-dir and the limits of configuration spaces, as several commands take them.
struct OntologyArguments {
    std::string path;
    std::vector<std::string> import_folders, plugins;
    knowledge::DiagramOptions limits;
    std::size_t diagram_mb = limits.memory_limit >> 20;
    void add_to(CLI::App& command, bool positional);
    /// Adds the measures of the plugins; read() does so first. Repeating it does nothing.
    void load_plugins() const;
    [[nodiscard]] owl::Ontology read(bool whole_core = true) const;
    [[nodiscard]] knowledge::CompileOptions compile_options() const;
    /// What the ontology means; of core only what it speaks of.
    [[nodiscard]] knowledge::Domain load() const { return knowledge::compile(read(false), compile_options()); }
};

}  // namespace partonomy::app
