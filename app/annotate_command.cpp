#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "algorithms/appearance.h"
#include "app/accepted_answers_file.h"
#include "app/commands.h"
#include "base/errors.h"
#include "expert/annotate.h"
#include "expert/place.h"
#include "mesh/appearance.h"
#include "mesh/read_mesh.h"
#include "report/part_names.h"
#include "report/write.h"
#include "report/write_all.h"

namespace partonomy::app {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::vector<std::string> meshes;
    OntologyArguments ontology;
    std::string output = "out";
    std::string up = "z", unit = "m";
    bool up_is_told = false;  ///< by the user; otherwise a glTF file tells its own
    bool unit_is_told = false;
    std::string answers;  ///< file of what a person says
    std::string strategy = "expert", criterion = "gain-per-cost";
    std::vector<std::string> formats = {"labels", "json", "ply", "glb", "png", "trace"};
    int threads = 0;
    bool quiet = false, json = false;
};

class Stopwatch {
public:
    [[nodiscard]] double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// One line on stderr that is overwritten, when a person is looking.
class Progress {
public:
    explicit Progress(bool quiet) : is_on_(!quiet && ::isatty(STDERR_FILENO)) {}
    ~Progress() { show(""); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void show(const std::string& text) const {
        if (is_on_) fmt::print(stderr, "\r\033[K{}", text);
    }

private:
    bool is_on_;
};

/// Output folder of each mesh; two meshes of the same name cannot share one.
std::vector<fs::path> output_folders(const Arguments& arguments) {
    std::vector<fs::path> folders;
    std::map<std::string, std::string> owners;
    for (const std::string& mesh : arguments.meshes) {
        const std::string stem = fs::path(mesh).stem().string();
        if (const auto [other, is_new] = owners.emplace(stem, mesh); !is_new)
            throw UsageError(
                fmt::format("{} and {} would both be written to {}: rename one, or annotate them into two folders",
                            other->second, mesh, (fs::path(arguments.output) / stem).string()));
        folders.push_back(fs::path(arguments.output) / stem);
    }
    return folders;
}

/// An ontology that is ready to be asked.
struct Knowhow {
    knowledge::Domain domain;
    Catalogue catalogue;
    double load_ms = 0;
};

Knowhow load(const OntologyArguments& ontology) {
    Stopwatch watch;
    Knowhow knowhow{ontology.load(), {}, 0};
    knowhow.catalogue = make_catalogue(knowhow.domain);
    knowhow.load_ms = watch.lap();
    return knowhow;
}

/// A mesh that was read and cut into candidate regions.
struct Input {
    Object object;
    MeshReport report;
    std::string sha256;
    double read_ms = 0;
    std::string up, unit;  ///< as words
};

/// `is_scene` may wait for the ontology: large meshes do, while a small one is cut at once and, should it be a scene,
/// again.
Input read_input(const Arguments& arguments, const std::string& mesh_path, const std::function<bool()>& is_scene) {
    constexpr std::size_t cut_at_once = 20'000;  // triangles
    Stopwatch watch;
    LoadedMesh loaded = read_mesh(mesh_path);
    const double read_ms = watch.lap();
    const std::string up_word = loaded.is_gltf && !arguments.up_is_told ? "y" : arguments.up;
    const std::string unit = loaded.is_gltf && !arguments.unit_is_told ? "m" : arguments.unit;
    const Vec3 up = up_word == "auto" ? resting_up(loaded.mesh) : parse_up(up_word);
    const Placement placement{up, parse_unit(unit)};
    const bool waits = loaded.mesh.triangles.size() > cut_at_once;
    return {make_object(std::move(loaded.mesh), placement, arguments.threads, waits && is_scene()),
            std::move(loaded.report),
            std::move(loaded.sha256),
            read_ms,
            up_word,
            unit};
}

/// What was found of up axis and unit, also as the first lines of the trace.
void tell(const Placing& placing, const Input& input, double ms, Annotation& annotation) {
    annotation.up = placing.up;
    annotation.unit = placing.unit;
    annotation.up_confidence = placing.up_confidence;
    annotation.unit_confidence = placing.unit_confidence;
    annotation.timings_ms.emplace_back("find up and unit", ms);
    std::vector<TraceEntry> found;
    if (input.up == "auto")
        found.push_back({"auto", "which axis points up", "mesh", placing.up, placing.up_confidence, {}, ms});
    if (input.unit == "auto")
        found.push_back({"auto", "which unit is it in", "mesh", placing.unit, placing.unit_confidence, {}, 0});
    annotation.trace.insert(annotation.trace.begin(), found.begin(), found.end());
    constexpr double sure = 0.6;
    if (input.up == "auto" && placing.up_confidence < sure)
        annotation.mesh_notes.push_back(fmt::format(
            "Which axis points up is not sure: {} was taken with a confidence of {:.2f} (0.5 is a toss-up); "
            "--up tells it.",
            placing.up, placing.up_confidence));
    if (input.unit == "auto" && placing.unit == "unknown")
        annotation.mesh_notes.emplace_back(
            "No unit is clearly the likeliest; --unit tells it, so that sizes can be asked.");
}

/// A note where sizes are asked of an object that the unit nobody told makes longer than a house.
void doubt_unit(const Arguments& arguments, const Knowhow& knowhow, const Input& input, Annotation& annotation) {
    constexpr double too_long = 50;  // metres
    if (arguments.unit_is_told || input.unit != "m" || knowhow.domain.is_about_scenes) return;
    if (std::ranges::none_of(knowhow.catalogue.algorithms, &ElementaryAlgorithm::needs_metres)) return;
    const Bounds bounds = compute_bounds(input.object.mesh);
    const double length = (bounds.high - bounds.low).maxCoeff();
    if (length <= too_long) return;
    constexpr double longest_likely = 10;  // metres
    const bool may_be_cm = length / 100 <= longest_likely;
    annotation.mesh_notes.push_back(fmt::format(
        "Read as {:.0f} m long, since no --unit was told, and sizes are asked for; is it --unit mm ({:.3g} m){}?",
        length, length / 1000, may_be_cm ? fmt::format(" or --unit cm ({:.3g} m)", length / 100) : ""));
}

/// What may keep objects from being anything: concepts that none can be, or that nothing proves.
void tell_about_objects(const knowledge::Domain& domain) {
    try {
        for (const std::string& warning : domain.object_warnings())
            fmt::print(stderr, "partonomy: note: {}\n", warning);
    } catch (const OntologyError& too_many) {
        fmt::print(stderr, "partonomy: note: {}\n", too_many.what());
    }
}

Annotation annotate_file(const Arguments& arguments, const Knowhow& knowhow, const std::vector<LearnedAnswer>& accepted,
                         Input& input, const std::string& mesh_path, const fs::path& folder, const Progress& progress) {
    Stopwatch watch;
    if (knowhow.domain.is_about_scenes && !input.object.is_scene) {
        input.object.is_scene = true;
        place(input.object, input.object.placement);
        cut(input.object, arguments.threads);
    }
    std::optional<Placing> placing;
    if (needs_appearance(knowhow.catalogue)) {
        progress.show(fmt::format("{}: looking", mesh_path));
        paint(input.object, read_appearance(mesh_path, input.sha256, input.object.mesh));
        input.read_ms += watch.lap();
    }
    if (input.up == "auto" || input.unit == "auto") {
        progress.show(fmt::format("{}: placing", mesh_path));
        placing =
            find_placement(knowhow.domain, knowhow.catalogue, input.object, {input.up, input.unit, arguments.threads});
    }
    const double placing_ms = watch.lap();
    progress.show(fmt::format("{}: asking", mesh_path));
    const Object& object = input.object;
    AnnotateOptions options{parse_strategy(arguments.strategy), parse_criterion(arguments.criterion)};
    options.threads = arguments.threads;
    options.accepted = accepted;
    options.accepted_source = arguments.answers;
    Annotation annotation = annotate(knowhow.domain, knowhow.catalogue, object, options);
    annotation.timings_ms.insert(annotation.timings_ms.begin(),
                                 {{"load ontology", knowhow.load_ms}, {"read mesh", input.read_ms}});
    annotation.mesh_file = mesh_path;
    annotation.mesh_sha256 = input.sha256;
    annotation.mesh_faces = object.mesh.input_face_count;
    annotation.mesh_notes = input.report.sentences();
    annotation.ontology_file = arguments.ontology.path;
    annotation.ontology_iri = knowhow.domain.ontology.iri;
    annotation.ontology_sha256 = knowhow.domain.ontology.sha256;
    annotation.up = input.up;
    annotation.unit = object.placement.metres_per_unit ? input.unit : "unknown";
    if (placing) tell(*placing, input, placing_ms, annotation);
    doubt_unit(arguments, knowhow, input, annotation);
    annotation.strategy = arguments.strategy;

    progress.show(fmt::format("{}: writing", mesh_path));
    write_outputs(folder, {arguments.formats.begin(), arguments.formats.end()}, object.mesh, annotation,
                  object.placement.up, {.threads = arguments.threads});
    return annotation;
}

/// "Chair", "FloorLamp, incompatible: LampThatTips", "not recognised, perhaps OneSidedDumbbell", "not recognised,
/// nearest: Chair, lacks 1 Seat": the picture's title in one line.
std::string verdict(const Annotation& annotation) {
    std::vector<std::string> classes, incompatible;
    for (const Diagnosis& diagnosis : annotation.diagnosis) incompatible.push_back(diagnosis.concept_name);
    for (const std::string& name : annotation.classes)
        if (std::ranges::find(incompatible, name) == incompatible.end()) classes.push_back(name);
    std::string text = classes.empty() ? "not recognised" : join(classes);
    if (!incompatible.empty()) text += ", incompatible: " + counted(incompatible);
    if (!annotation.perhaps.empty()) text += ", perhaps " + join(annotation.perhaps);
    if (!annotation.nearest.empty()) text += ", nearest: " + in_words(annotation.nearest.front());
    return text;
}

std::string summary(const Annotation& annotation, const fs::path& folder) {
    std::vector<std::string> parts, composites;
    for (const AnnotatedPart& part : annotation.parts)
        if (!part.is_piece) parts.push_back(all_names_of(part));
    for (const AnnotatedComposite& composite : annotation.composites) composites.push_back(all_names_of(composite));
    std::string named = counted(parts);
    if (!composites.empty()) named += (parts.empty() ? "wholes: " : "; wholes: ") + counted(composites);
    if (named.empty()) named = "no parts";
    std::string related;  // only where the ontology has relations or composite parts
    for (const char* kind : {"T", "TF"})
        if (annotation.questions.at(kind) > 0) related += fmt::format(", {} {}", kind, annotation.questions.at(kind));
    return fmt::format("{}: {} ({:.2f}): {}; SF {}, SI {}{} -> {}", annotation.mesh_file, verdict(annotation),
                       annotation.score, named, annotation.questions.at("SF"), annotation.questions.at("SI"), related,
                       folder.string());
}

/// At least one class that is no diagnosis.
bool is_recognised(const Annotation& annotation) {
    for (const std::string& name : annotation.classes) {
        bool is_diagnosis = false;
        for (const Diagnosis& diagnosis : annotation.diagnosis) is_diagnosis |= diagnosis.concept_name == name;
        if (!is_diagnosis) return true;
    }
    return false;
}

int run_annotate(const Arguments& arguments) {
    if (arguments.up != "auto") static_cast<void>(parse_up(arguments.up));
    static_cast<void>(parse_unit(arguments.unit));
    static_cast<void>(parse_strategy(arguments.strategy));
    static_cast<void>(parse_criterion(arguments.criterion));
    check_formats({arguments.formats.begin(), arguments.formats.end()});
    const std::vector<fs::path> folders = output_folders(arguments);
    std::vector<LearnedAnswer> accepted;
    if (!arguments.answers.empty()) {
        if (arguments.meshes.size() > 1)
            throw UsageError("--answers " + arguments.answers + ": tells of the parts of one mesh; annotate it alone");
        accepted = load_accepted_answers(arguments.answers);
    }
    const Progress progress(arguments.quiet);
    // Cutting a mesh needs no ontology: with a thread to spare, the ontology is read while the first mesh is cut.
    progress.show("reading " + arguments.ontology.path + " and " + arguments.meshes.front());
    const std::shared_future<Knowhow> loading = std::async(
        arguments.threads == 1 ? std::launch::deferred : std::launch::async, [&] { return load(arguments.ontology); });
    const auto is_scene = [&loading] { return loading.get().domain.is_about_scenes; };
    if (arguments.threads == 1) loading.wait();
    std::optional<Input> first;
    std::exception_ptr first_error;
    try {
        first = read_input(arguments, arguments.meshes.front(), is_scene);
    } catch (const Error&) {
        first_error = std::current_exception();  // told in its turn, after what is wrong with the ontology
    }
    const Knowhow& knowhow = loading.get();
    progress.show("");
    if (!arguments.quiet)
        for (const std::string& warning : knowhow.domain.warnings) fmt::print(stderr, "partonomy: note: {}\n", warning);

    int exit_code = recognised;
    bool is_told = arguments.quiet;
    for (std::size_t i = 0; i < arguments.meshes.size(); ++i) {
        try {
            const std::string& mesh = arguments.meshes[i];
            progress.show(fmt::format("{}: reading", mesh));
            if (i == 0 && first_error) std::rethrow_exception(first_error);
            Input input = i == 0 ? *std::exchange(first, std::nullopt) : read_input(arguments, mesh, is_scene);
            const Annotation annotation =
                annotate_file(arguments, knowhow, accepted, input, mesh, folders[i], progress);
            progress.show("");
            if (!arguments.quiet) {
                for (const std::string& note : annotation.mesh_notes) fmt::print(stderr, "{}: note: {}\n", mesh, note);
                fmt::print("{}\n", summary(annotation, folders[i]));
            }
            if (!is_recognised(annotation) && !std::exchange(is_told, true)) tell_about_objects(knowhow.domain);
            if (arguments.json) fmt::print("{}\n", to_json(annotation));
            if (exit_code == recognised && (!annotation.consistent || !is_recognised(annotation)))
                exit_code = incompatible;
        } catch (const Error& error) {
            progress.show("");
            fmt::print(stderr, "partonomy: {}\n", error.what());
            exit_code = bad_input;
        }
    }
    return exit_code;
}

}  // namespace

void add_annotate_command(CLI::App& app, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("annotate", "cut meshes into named parts");
    command.add_option("MESH", arguments->meshes, "OFF, OBJ, STL, PLY, glTF or GLB files")->required();
    arguments->ontology.add_to(command, false);
    command
        .add_option("-o,--output", arguments->output, "folder to write to; each mesh gets a folder of its own in it")
        ->capture_default_str();
    const CLI::Option* up =
        command.add_option("--up", arguments->up, "axis that points up: x, -x, y, -y, z, -z; auto finds it (glTF: y)")
            ->capture_default_str();
    const CLI::Option* unit =
        command
            .add_option("--unit", arguments->unit,
                        "unit of the file: m, cm, mm, in; auto finds it, or leaves questions of size open")
            ->capture_default_str();
    command.add_option("--answers", arguments->answers,
                       "JSON list of answers that a person gives or corrects, as knowledge.answers of annotation.json");
    command.add_option("--strategy", arguments->strategy, "expert, naive or segment-then-identify")
        ->capture_default_str();
    command.add_option("--criterion", arguments->criterion, "gain-per-cost or dichotomy")->capture_default_str();
    command.add_option("--threads", arguments->threads, "threads to use; 0 for all cores")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command.add_option("--format", arguments->formats, "what to write: labels,json,ply,glb,png,trace")
        ->delimiter(',')
        ->capture_default_str();
    command.add_flag("--quiet,-q", arguments->quiet, "print nothing but errors");
    command.add_flag("--json", arguments->json, "print each annotation on standard output");
    command.callback([arguments, up, unit, &run] {
        arguments->up_is_told = up->count() > 0;
        arguments->unit_is_told = unit->count() > 0;
        run = [arguments] { return run_annotate(*arguments); };
    });
}

}  // namespace partonomy::app
