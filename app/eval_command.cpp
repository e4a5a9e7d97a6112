#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "algorithms/object.h"
#include "app/commands.h"
#include "base/errors.h"
#include "base/files.h"
#include "mesh/read_mesh.h"
#include "report/boundaries.h"
#include "report/eval_pictures.h"
#include "report/evaluate.h"
#include "report/recognition.h"

namespace partonomy::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Arguments {
    std::string run_folder, truth, classes, mesh, pictures;
    std::vector<std::string> names;
    int worst = 8;
    bool json = false;
};

std::map<std::string, std::string> parse_names(const std::vector<std::string>& pairs) {
    std::map<std::string, std::string> names;
    for (const std::string& pair : pairs) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError("--names " + pair + ": not a pair, use truth=Concept, such as support=Seat");
        if (!names.emplace(pair.substr(0, equals), pair.substr(equals + 1)).second)
            throw UsageError("--names " + pair + ": " + pair.substr(0, equals) +
                             " has a name already; a label has one");
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

std::string stem_of(const fs::path& folder) {
    return folder.filename().empty() ? folder.parent_path().filename().string() : folder.filename().string();
}

/// The truth of one mesh: the given file, or the one of its name in the given folder; empty when there is none.
fs::path truth_file(const fs::path& truth, const std::string& stem) {
    if (!fs::is_directory(truth)) return truth;
    for (const char* ending : {"_labels.txt", ".labels.txt", ".lab", ".seg", ".txt", ".ply"})
        if (fs::exists(truth / (stem + ending))) return truth / (stem + ending);
    return {};
}

/// The folders that have a truth; says which have none. Throws UsageError when none has.
std::vector<fs::path> with_truth(const std::vector<fs::path>& folders, const std::string& truth) {
    std::vector<fs::path> found;
    std::string without;
    for (const fs::path& folder : folders)
        if (truth_file(truth, stem_of(folder)).empty())
            without += (without.empty() ? "" : ", ") + stem_of(folder);
        else
            found.push_back(folder);
    const std::string said = fmt::format(
        "{}: holds no truth for {} (NAME_labels.txt, .labels.txt, .lab, .seg, .txt or .ply)", truth, without);
    if (found.empty()) throw UsageError(said);
    if (!without.empty()) fmt::print(stderr, "note: {}\n", said);
    return found;
}

/// Faces are called by their piece; where the truth speaks of the whole, and all pieces of that name are in such
/// wholes, they are called by the whole.
void name_wholes(const nlohmann::json& annotation, const std::vector<std::string>& truth,
                 std::vector<std::string>& labels) {
    if (!annotation.is_object() || !annotation.contains("composites")) return;
    const std::set<std::string> wanted(truth.begin(), truth.end());
    std::map<std::string, std::set<std::string>> wholes;  // of each name of a piece; "" for a piece in none
    for (const auto& part : annotation.at("parts")) {
        if (part.at("concepts").empty()) continue;
        const std::string piece = part.at("concepts").front().get<std::string>();
        if (wanted.contains(piece)) continue;
        std::string whole;
        for (const auto& composite : annotation.at("composites"))
            if (std::ranges::find(composite.at("parts"), part.at("id")) != composite.at("parts").end())
                for (const auto& name : composite.at("concepts"))
                    if (whole.empty() && wanted.contains(name.get<std::string>())) whole = name.get<std::string>();
        wholes[piece].insert(whole);
    }
    for (std::string& label : labels)
        if (const auto found = wholes.find(label);
            found != wholes.end() && found->second.size() == 1 && !found->second.begin()->empty())
            label = *found->second.begin();
}

/// Whether a face of the mesh has a name in truth; a mesh of which none has is of no kind that the ontology knows.
bool is_of_a_kind(const std::vector<std::string>& truth) {
    return std::ranges::any_of(truth, [](const std::string& label) { return !label.empty() && label != "-"; });
}

/// The classes that an annotated object was recognised as, or all that hold of it, diagnoses left out; nullopt where
/// the annotation is lost.
Recognition::Classes classes_of(const nlohmann::json& annotation, const char* which) {
    if (!annotation.is_object() || !annotation.contains("object") || !annotation.contains("diagnosis")) return {};
    auto classes = annotation.at("object").at(which).get<std::vector<std::string>>();
    for (const auto& diagnosis : annotation.at("diagnosis")) std::erase(classes, diagnosis.at("concept"));
    return classes;
}

/// A label of the truth that no face has may be called otherwise in the ontology.
void note_unknown_labels(const std::string& mesh, const std::vector<std::string>& truth,
                         const std::vector<std::string>& labels) {
    const std::set<std::string> said(labels.begin(), labels.end());
    std::string names;
    for (const std::string& label : said)
        if (!label.empty() && label != "-") names += (names.empty() ? "" : ", ") + label;
    if (names.empty()) return;  // nothing has a name: then the object was not recognised
    if (std::ranges::any_of(truth, [&](const std::string& label) { return said.contains(label); })) return;
    fmt::print(stderr,
               "note: {}: no face has a name that the truth knows; the names are {}: give pairs, --names truth=Name\n",
               mesh, names);
}

nlohmann::json annotation_in(const fs::path& folder) {
    const fs::path path = folder / "annotation.json";
    return fs::exists(path) ? nlohmann::json::parse(read_file(path), nullptr, false) : nlohmann::json();
}

std::string mesh_of(const nlohmann::json& annotation, const fs::path& folder) {
    if (annotation.is_object() && annotation.contains("mesh") && annotation["mesh"].contains("file"))
        return annotation["mesh"]["file"].get<std::string>();
    throw UsageError(at((folder / "annotation.json").string(), 0, "does not name its mesh; give it with --mesh"));
}

/// The up axis that the annotation names; z when it names none.
Vec3 up_of(const nlohmann::json& annotation) {
    if (!annotation.is_object() || !annotation.contains("mesh") || !annotation["mesh"].contains("up"))
        return Vec3::UnitZ();
    return parse_up(annotation["mesh"]["up"].get<std::string>());
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

/// One annotated mesh beside its truth.
struct Compared {
    Evaluation result;
    BoundaryScore boundaries;
    SheetEntry entry;  ///< its title is the mesh's name
};

/// nullopt for a mesh of no kind. Whatever it is, what it was recognised as is added.
std::optional<Compared> compare(const Arguments& arguments, const std::map<std::string, std::string>& classes,
                                const fs::path& folder, Recognition& recognition) {
    const std::string stem = stem_of(folder);
    Compared compared;
    SheetEntry& entry = compared.entry;
    entry.title = stem;
    const nlohmann::json annotation = annotation_in(folder);
    entry.mesh = read_mesh(arguments.mesh.empty() ? mesh_of(annotation, folder) : arguments.mesh).mesh;
    entry.truth = read_truth(truth_file(arguments.truth, stem).string(), entry.mesh.input_face_count,
                             parse_names(arguments.names));
    entry.labels = lines_of(folder / "labels.txt");
    if (!is_of_a_kind(entry.truth)) {
        recognition.add_of_no_kind(stem, classes_of(annotation, "classes"));
        return std::nullopt;
    }
    const auto truth = classes.find(stem);
    if (truth != classes.end() && truth->second == "-")
        recognition.add_of_no_kind(stem, classes_of(annotation, "classes"));
    if (truth != classes.end() && truth->second != "-") {
        const auto all = classes_of(annotation, "all_classes"), told = classes_of(annotation, "classes");
        const bool is_right = all && std::ranges::find(*all, truth->second) != all->end();
        recognition.add(stem, truth->second, is_right ? all : told);
    }
    name_wholes(annotation, entry.truth, entry.labels);
    note_unknown_labels(stem, entry.truth, entry.labels);
    compared.result = evaluate_labels(entry.labels, entry.truth, input_face_areas(entry.mesh));
    compared.boundaries = compare_boundaries(entry.mesh, entry.labels, entry.truth);
    if (!arguments.pictures.empty()) entry.up = up_of(annotation);
    return compared;
}

/// Keeps the worst meshes, the very worst first.
class Worst {
public:
    explicit Worst(int most) : most_(static_cast<std::size_t>(most)) {}

    void add(double accuracy, SheetEntry entry) {
        entry.title += fmt::format(": {:.4f}", accuracy);
        const auto place = std::upper_bound(entries_.begin(), entries_.end(), accuracy,
                                            [](double value, const auto& other) { return value < other.first; });
        entries_.insert(place, {accuracy, std::move(entry)});
        if (entries_.size() > most_) entries_.pop_back();
    }

    [[nodiscard]] std::vector<SheetEntry> take() {
        std::vector<SheetEntry> sheet;
        for (auto& [accuracy, entry] : entries_) sheet.push_back(std::move(entry));
        return sheet;
    }

private:
    std::size_t most_;
    std::vector<std::pair<double, SheetEntry>> entries_;
};

void write_pictures(const fs::path& folder, const std::map<std::string, std::map<std::string, double>>& confusion,
                    const std::vector<SheetEntry>& worst) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(at(folder.string(), 0, "cannot be made: " + error.message()));
    if (worst.empty()) return;  // every mesh is of no kind
    write_file(folder / "confusion.png", confusion_picture(confusion));
    write_file(folder / "worst.png", contact_sheet(worst));
}

/// Sums, then means, over the compared meshes.
struct Means {
    double area_accuracy = 0, face_accuracy = 0, rand_index_error = 0, boundary = 0;
    std::map<std::string, std::pair<double, int>> iou;  ///< sum, and meshes that have the label
    std::map<std::string, std::map<std::string, double>> confusion;
    int count = 0;

    void add(const Compared& compared) {
        const Evaluation& result = compared.result;
        ++count;
        area_accuracy += result.area_accuracy;
        face_accuracy += result.face_accuracy;
        rand_index_error += result.rand_index_error;
        boundary += compared.boundaries.f();
        for (const auto& [label, value] : result.iou) {
            iou[label].first += value;
            ++iou[label].second;
        }
        for (const auto& [truth, row] : result.confusion)
            for (const auto& [answer, share] : row) confusion[truth][answer] += share;
    }

    void divide() {
        if (count == 0) return;
        for (double* sum : {&area_accuracy, &face_accuracy, &rand_index_error, &boundary}) *sum /= count;
        for (auto& [label, sum] : iou) sum.first /= sum.second;
        for (auto& [truth, row] : confusion)
            for (auto& [answer, share] : row) share /= count;
    }
};

void print_row(const std::string& name, double area_accuracy, double face_accuracy, double rand_index_error,
               double boundary, const std::map<std::string, double>& iou) {
    std::string labels;
    for (const auto& [label, value] : iou) labels += fmt::format("{} {:.3f}  ", label, value);
    fmt::print("{:<24} {:>9.4f} {:>9.4f} {:>9.4f} {:>9.4f}  {}\n", name, area_accuracy, face_accuracy, rand_index_error,
               boundary, labels);
}

ordered_json in_json(const Compared& compared) {
    const auto& [result, boundaries, entry] = compared;
    return {{"mesh", entry.title},
            {"area_accuracy", result.area_accuracy},
            {"face_accuracy", result.face_accuracy},
            {"rand_index_error", result.rand_index_error},
            {"boundary", {{"f", boundaries.f()}, {"precision", boundaries.precision}, {"recall", boundaries.recall}}},
            {"iou", result.iou},
            {"confusion", result.confusion}};
}

ordered_json in_json(const ordered_json& meshes, const Means& means, const std::map<std::string, double>& iou,
                     const Recognition& recognition) {
    ordered_json report = {{"meshes", meshes}, {"mean_area_accuracy", nullptr}, {"mean", nullptr}};
    if (means.count > 0) {
        report["mean_area_accuracy"] = means.area_accuracy;
        report["mean"] = {{"area_accuracy", means.area_accuracy},
                          {"face_accuracy", means.face_accuracy},
                          {"rand_index_error", means.rand_index_error},
                          {"boundary", means.boundary},
                          {"iou", iou}};
    }
    report["confusion"] = means.confusion;
    if (recognition.of_a_class() > 0)
        report["classes"] = {
            {"right", recognition.right}, {"of", recognition.of_a_class()}, {"wrong", recognition.wrong}};
    report["no_kind"] = {{"rightly_not_recognised", recognition.rightly_not_recognised},
                         {"recognised", recognition.recognised},
                         {"unknown", recognition.unknown}};
    return report;
}

int run_eval(const Arguments& arguments) {
    ordered_json meshes = ordered_json::array();
    Means means;
    Recognition recognition;
    Worst worst(arguments.worst);
    std::map<std::string, std::string> classes;
    if (!arguments.classes.empty()) classes = read_classes(read_file(arguments.classes), arguments.classes);
    const std::vector<fs::path> folders = with_truth(annotated_folders(arguments.run_folder), arguments.truth);
    for (const fs::path& folder : folders) {
        std::optional<Compared> compared = compare(arguments, classes, folder, recognition);
        if (!compared) continue;
        if (means.count == 0 && !arguments.json)
            fmt::print("{:<24} {:>9} {:>9} {:>9} {:>9}  {}\n", "mesh", "area acc.", "face acc.", "Rand err.",
                       "border F", "IoU by label");
        means.add(*compared);
        const Evaluation& result = compared->result;
        if (arguments.json)
            meshes.push_back(in_json(*compared));
        else
            print_row(compared->entry.title, result.area_accuracy, result.face_accuracy, result.rand_index_error,
                      compared->boundaries.f(), result.iou);
        if (!arguments.pictures.empty()) worst.add(result.area_accuracy, std::move(compared->entry));
    }
    means.divide();
    std::map<std::string, double> iou;
    for (const auto& [label, mean] : means.iou) iou[label] = mean.first;
    if (!arguments.pictures.empty()) write_pictures(arguments.pictures, means.confusion, worst.take());
    if (arguments.json) {
        fmt::print("{}\n", in_json(meshes, means, iou, recognition).dump(2));
        return recognised;
    }
    if (means.count > 0)
        print_row("mean", means.area_accuracy, means.face_accuracy, means.rand_index_error, means.boundary, iou);
    if (recognition.of_a_class() > 0) fmt::print("{}\n", recognition.classes_in_words());
    if (recognition.of_no_kind() > 0) fmt::print("{}\n", recognition.no_kind_in_words());
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
    command.add_option("--classes", arguments->classes,
                       "file with the true class of each object, a line each: chair3 Chair");
    command.add_option("--mesh", arguments->mesh, "the mesh, when it is not where it was annotated");
    command.add_option("--pictures", arguments->pictures,
                       "folder for confusion.png and worst.png, the worst meshes beside their truth");
    command.add_option("--worst", arguments->worst, "how many meshes worst.png shows")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command.add_flag("--json", arguments->json, "print JSON");
    command.callback([arguments, &run] { run = [arguments] { return run_eval(*arguments); }; });
}

}  // namespace partonomy::app
