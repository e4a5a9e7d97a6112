// Writes annotation.json; docs/annotation.md is the schema. Keys keep the order in which they are written here, and
// maps are sorted, so equal annotations give equal bytes. Numbers are the shortest that read back as the same double; a
// number that is not finite becomes null, and bytes that are not UTF-8 (file names may hold any) become U+FFFD.

#include <nlohmann/json.hpp>

#include "report/write.h"

namespace partonomy {
namespace {

using Json = nlohmann::ordered_json;

template <class Map>
Json object_of(const Map& map) {
    Json object = Json::object();
    for (const auto& [key, value] : map) object[key] = value;
    return object;
}

Json part_to_json(const AnnotatedPart& part) {
    Json json;
    json["id"] = part.id;
    json["concepts"] = part.concepts;
    json["faces"] = part.faces;
    json["triangles"] = part.triangles.size();
    json["area"] = part.area;
    json["score"] = part.score;
    json["features"] = object_of(part.features);
    json["measurements"] = object_of(part.measurements);
    const auto [red, green, blue] = color_of(part);
    constexpr char digits[] = "0123456789abcdef";
    std::string color = "#";
    for (const std::uint8_t channel : {red, green, blue}) {
        color += digits[channel >> 4];
        color += digits[channel & 15];
    }
    json["color"] = color;
    return json;
}

Json composite_to_json(const AnnotatedComposite& composite) {
    return {{"id", composite.id},
            {"concepts", composite.concepts},
            {"parts", composite.parts},
            {"composites", composite.composites}};
}

Json trace_to_json(const TraceEntry& entry) {
    Json json;
    json["kind"] = entry.kind;
    json["question"] = entry.question;
    json["region"] = entry.region;
    json["answer"] = entry.answer;
    json["score"] = entry.score;
    json["inferred"] = entry.inferred;
    json["ms"] = entry.ms;
    return json;
}

Json diagnosis_to_json(const Diagnosis& diagnosis) {
    Json json;
    json["concept"] = diagnosis.concept_name;
    json["parts"] = diagnosis.parts;
    json["answers"] = diagnosis.answers;
    json["axioms"] = diagnosis.axioms;
    json["corrections"] = diagnosis.corrections;
    json["changes"] = Json::array();
    for (const auto& [answers, cost] : diagnosis.changes)
        json["changes"].push_back({{"answers", answers}, {"cost", cost}});
    return json;
}

Json answer_to_json(const LearnedAnswer& answer) {
    return {{"part", answer.part},
            {"feature", answer.feature},
            {"value", answer.value},
            {"yes", answer.yes},
            {"score", answer.score}};
}

Json questions_to_json(const std::map<std::string, int>& questions) {
    Json json = {{"SF", 0}, {"SI", 0}, {"T", 0}, {"TF", 0}};
    for (const auto& [kind, count] : questions) json[kind] = count;
    return json;
}

Json list_of(const auto& values, auto to_one) {
    Json list = Json::array();
    for (const auto& value : values) list.push_back(to_one(value));
    return list;
}

}  // namespace

std::string to_json(const Annotation& annotation) {
    Json json;
    json["mesh"] = {{"file", annotation.mesh_file},
                    {"sha256", annotation.mesh_sha256},
                    {"faces", annotation.mesh_faces},
                    {"triangles", annotation.part_of_triangle.size()},
                    {"up", annotation.up},
                    {"up_confidence", annotation.up_confidence},
                    {"unit", annotation.unit},
                    {"unit_confidence", annotation.unit_confidence}};
    json["mesh"]["notes"] = annotation.mesh_notes;
    json["ontology"] = {
        {"iri", annotation.ontology_iri}, {"sha256", annotation.ontology_sha256}, {"file", annotation.ontology_file}};
    json["strategy"] = annotation.strategy;
    json["object"]["classes"] = annotation.classes;
    json["object"]["consistent"] = annotation.consistent;
    json["object"]["score"] = annotation.score;
    json["object"]["all_classes"] = annotation.all_classes;
    json["parts"] = list_of(annotation.parts, part_to_json);
    json["composites"] = list_of(annotation.composites, composite_to_json);
    json["questions"] = questions_to_json(annotation.questions);
    json["trace"] = list_of(annotation.trace, trace_to_json);
    json["knowledge"] = {{"complete", annotation.is_complete},
                         {"connected", annotation.connected},
                         {"answers", list_of(annotation.answers, answer_to_json)}};
    json["diagnosis"] = list_of(annotation.diagnosis, diagnosis_to_json);
    json["open_questions"] = annotation.open_questions;
    json["timings_ms"] = object_of(annotation.timings_ms);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace partonomy
