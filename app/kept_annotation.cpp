#include "app/kept_annotation.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/files.h"

namespace partonomy::app {

using nlohmann::json;

std::filesystem::path annotation_path(const std::string& told) {
    const std::filesystem::path path = told;
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored) ? path : path / "annotation.json";
}

namespace {

/// Where a folder holds no annotation, but its subfolders do, one of them is meant.
void refuse_folder_of_many(const std::string& told) {
    namespace fs = std::filesystem;
    constexpr std::size_t shown = 6;
    std::error_code ignored;
    if (!fs::is_directory(told, ignored) || fs::exists(annotation_path(told), ignored)) return;
    std::vector<std::string> folders;
    for (const fs::directory_entry& entry : fs::directory_iterator(told, ignored))
        if (fs::exists(entry.path() / "annotation.json", ignored))
            folders.push_back((fs::path(told) / entry.path().filename()).string());
    if (folders.empty()) return;
    std::ranges::sort(folders);
    std::string names;
    for (std::size_t i = 0; i < std::min(shown, folders.size()); ++i) names += (i > 0 ? ", " : "") + folders[i];
    if (folders.size() > shown) names += " and " + std::to_string(folders.size() - shown) + " more";
    throw UsageError(at(told, 0, "holds several annotated meshes; name one of them: " + names));
}

}  // namespace

json load_annotation(const std::string& told) {
    refuse_folder_of_many(told);
    const std::filesystem::path path = annotation_path(told);
    json annotation = json::parse(read_file(path), nullptr, false);
    if (annotation.is_discarded() || !annotation.is_object())
        throw UsageError(at(path.string(), 0, "is not an annotation; run partonomy annotate again"));
    return annotation;
}

knowledge::Domain load_same_ontology(OntologyArguments arguments, const json& annotation) {
    const json& used = annotation.at("ontology");
    if (arguments.path.empty()) arguments.path = used.at("file").get<std::string>();
    owl::Ontology ontology = arguments.read();
    if (ontology.sha256 != used.at("sha256").get<std::string>())
        throw UsageError(at(arguments.path, 0, "is not the ontology that the mesh was annotated with; annotate again"));
    return knowledge::compile(std::move(ontology), arguments.compile_options());
}

std::vector<LearnedAnswer> answers_of(const json& annotation) {
    std::vector<LearnedAnswer> answers;
    for (const json& each : annotation.at("knowledge").at("answers"))
        answers.push_back({each.at("part").get<int>(), each.at("feature").get<std::string>(),
                           each.at("value").get<std::string>(), each.at("yes").get<bool>(),
                           each.at("score").get<double>(), each.value("accepted", false), each.value("measured", "")});
    return answers;
}

knowledge::Knowledge knowledge_of(const knowledge::Domain& domain, const json& annotation) {
    const json& kept = annotation.at("knowledge");
    return recall(domain, static_cast<int>(annotation.at("parts").size()), kept.at("complete").get<bool>(),
                  answers_of(annotation), kept.at("connected").get<std::vector<std::pair<int, int>>>());
}

}  // namespace partonomy::app
