#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/errors.h"
#include "base/files.h"
#include "mesh/read_mesh.h"
#include "report/evaluate.h"

namespace partonomy::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Arguments {
    std::string run_folder, truth, mesh;
    std::vector<std::string> names;
    bool json = false;
};

std::map<std::string, std::string> parse_names(const std::vector<std::string>& pairs) {
    std::map<std::string, std::string> names;
    for (const std::string& pair : pairs) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError("--names " + pair + ": not a pair, use truth=Concept, such as support=Seat");
        names[pair.substr(0, equals)] = pair.substr(equals + 1);
    }
    return names;
}

/// The folders to compare: the given one, or each of its subfolders that holds labels.txt; sorted.
std::vector<fs::path> annotated_folders(const fs::path& folder) {
    if (!fs::is_directory(folder)) throw FileError(at(folder.string(), 0, "no such folder"));
    if (fs::exists(folder / "labels.txt")) return {folder};
    std::vector<fs::path> folders;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (fs::exists(entry.path() / "labels.txt")) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    if (folders.empty())
        throw UsageError(
            at(folder.string(), 0, "holds no labels.txt, nor has a subfolder with one; run partonomy annotate first"));
    return folders;
}

/// The truth of one mesh: the given file, or the one of its name in the given folder.
fs::path truth_file(const fs::path& truth, const std::string& stem) {
    if (!fs::is_directory(truth)) return truth;
    for (const char* ending : {"_labels.txt", ".labels.txt", ".lab", ".seg", ".txt", ".ply"})
        if (fs::exists(truth / (stem + ending))) return truth / (stem + ending);
    throw UsageError(fmt::format("{}: holds no truth for {} ({}_labels.txt, .labels.txt, .lab, .seg, .txt or .ply)",
                                 truth.string(), stem, stem));
}

std::string mesh_of(const fs::path& folder) {
    const fs::path path = folder / "annotation.json";
    const auto annotation = nlohmann::json::parse(read_file(path), nullptr, false);
    if (annotation.is_object() && annotation.contains("mesh") && annotation["mesh"].contains("file"))
        return annotation["mesh"]["file"].get<std::string>();
    throw UsageError(at(path.string(), 0, "does not name its mesh; give it with --mesh"));
}

std::vector<std::string> lines_of(const fs::path& path) {
    std::vector<std::string> lines;
    std::string line;
    for (const char c : read_file(path))
        if (c == '\n')
            lines.push_back(std::exchange(line, {}));
        else
            line += c;
    if (!line.empty()) lines.push_back(line);
    return lines;
}

int run_eval(const Arguments& arguments) {
    const std::map<std::string, std::string> names = parse_names(arguments.names);
    ordered_json results = ordered_json::array();
    double mean = 0;
    const std::vector<fs::path> folders = annotated_folders(arguments.run_folder);
    if (!arguments.json)
        fmt::print("{:<24} {:>9} {:>9} {:>9}  {}\n", "mesh", "area acc.", "face acc.", "Rand err.", "IoU by label");
    for (const fs::path& folder : folders) {
        const std::string stem =
            folder.filename().empty() ? folder.parent_path().filename().string() : folder.filename().string();
        const LoadedMesh loaded = read_mesh(arguments.mesh.empty() ? mesh_of(folder) : arguments.mesh);
        const std::vector<std::string> truth =
            read_truth(truth_file(arguments.truth, stem).string(), loaded.mesh.input_face_count, names);
        const Evaluation result =
            evaluate_labels(lines_of(folder / "labels.txt"), truth, input_face_areas(loaded.mesh));
        mean += result.area_accuracy / static_cast<double>(folders.size());
        if (arguments.json) {
            results.push_back({{"mesh", stem},
                               {"area_accuracy", result.area_accuracy},
                               {"face_accuracy", result.face_accuracy},
                               {"rand_index_error", result.rand_index_error},
                               {"iou", result.iou},
                               {"confusion", result.confusion}});
        } else {
            std::string iou;
            for (const auto& [label, value] : result.iou) iou += fmt::format("{} {:.3f}  ", label, value);
            fmt::print("{:<24} {:>9.4f} {:>9.4f} {:>9.4f}  {}\n", stem, result.area_accuracy, result.face_accuracy,
                       result.rand_index_error, iou);
        }
    }
    if (arguments.json)
        fmt::print("{}\n", ordered_json{{"meshes", results}, {"mean_area_accuracy", mean}}.dump(2));
    else
        fmt::print("{:<24} {:>9.4f}\n", "mean", mean);
    return recognised;
}

}  // namespace

void add_eval_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("eval", "accuracy of annotated meshes against a truth");
    command.add_option("DIR", arguments->run_folder, "folder of one annotated mesh, or of many")->required();
    command
        .add_option("--truth", arguments->truth, "file with true labels, or a folder of them named after the meshes")
        ->required();
    command
        .add_option("--names", arguments->names, "what truth labels are called in the ontology: support=Seat,leg=Leg")
        ->delimiter(',');
    command.add_option("--mesh", arguments->mesh, "the mesh, when it is not where it was annotated");
    command.add_flag("--json", arguments->json, "print JSON");
    command.callback([arguments, &run] { run = [arguments] { return run_eval(*arguments); }; });
}

}  // namespace partonomy::app
