// Writes annotation.json; docs/annotation.md is the schema. Keys keep the order in which they are written here, and
// maps are sorted, so equal annotations give equal bytes. Numbers are the shortest that read back as the same double; a
// number that is not finite becomes null, and bytes that are not UTF-8 (file names may hold any) become U+FFFD.

#include "base/json_text.h"
#include "report/write.h"

namespace partonomy {
namespace {

std::string hex_color(const AnnotatedPart& part) {
    constexpr char digits[] = "0123456789abcdef";
    std::string color = "#";
    for (const std::uint8_t channel : color_of(part)) {
        color += digits[channel >> 4];
        color += digits[channel & 15];
    }
    return color;
}

void write_parts(JsonText& json, const Annotation& annotation) {
    json.array("parts");
    for (const AnnotatedPart& part : annotation.parts) {
        json.object()
            .member("id", part.id)
            .member("concepts", part.concepts)
            .member("faces", part.faces)
            .member("triangles", part.triangles.size())
            .member("area", part.area)
            .member("score", part.score)
            .member("features", part.features)
            .member("measurements", part.measurements)
            .member("color", hex_color(part));
        if (!part.nearest.empty())
            json.object("nearest").member("concept", part.nearest).member("refused_by", part.refusals).end();
        json.end();
    }
    json.end().array("composites");
    for (const AnnotatedComposite& composite : annotation.composites)
        json.object()
            .member("id", composite.id)
            .member("concepts", composite.concepts)
            .member("parts", composite.parts)
            .member("composites", composite.composites)
            .end();
    json.end();
}

void write_questions(JsonText& json, const Annotation& annotation) {
    json.object("questions");
    std::map<std::string, int> others = annotation.questions;
    for (const char* kind : {"SF", "SI", "T", "TF", "read_off"}) {
        const auto counted = others.extract(kind);
        json.member(kind, counted ? counted.mapped() : 0);
    }
    for (const auto& [kind, count] : others) json.member(kind, count);
    json.end().array("trace");
    for (const TraceEntry& entry : annotation.trace) {
        json.object()
            .member("kind", entry.kind)
            .member("question", entry.question)
            .member("region", entry.region)
            .member("answer", entry.answer)
            .member("score", entry.score)
            .member("inferred", entry.inferred)
            .member("ms", entry.ms);
        if (!entry.measured.empty()) json.member("measured", entry.measured);
        json.end();
    }
    json.end();
}

void write_knowledge(JsonText& json, const Annotation& annotation) {
    json.object("knowledge").member("complete", annotation.is_complete).member("connected", annotation.connected);
    json.array("answers");
    for (const LearnedAnswer& answer : annotation.answers) {
        json.object()
            .member("part", answer.part)
            .member("feature", answer.feature)
            .member("value", answer.value)
            .member("yes", answer.yes)
            .member("score", answer.score);
        if (answer.accepted) json.member("accepted", true);
        if (!answer.measured.empty()) json.member("measured", answer.measured);
        json.end();
    }
    json.end().end().array("diagnosis");
    for (const Diagnosis& diagnosis : annotation.diagnosis) {
        json.object().member("concept", diagnosis.concept_name);
        if (!diagnosis.comment.empty()) json.member("comment", diagnosis.comment);
        json.member("parts", diagnosis.parts)
            .member("answers", diagnosis.answers)
            .member("axioms", diagnosis.axioms)
            .member("corrections", diagnosis.corrections);
        if (!diagnosis.given.empty())
            json.object("given")
                .member("concepts", diagnosis.given)
                .member("answers", diagnosis.answers_of_given)
                .end();
        if (!diagnosis.nearest.empty()) {
            json.array("nearest");
            for (const Diagnosis::NearPart& near : diagnosis.nearest)
                json.object()
                    .member("part", near.part)
                    .member("concept", near.concept_name)
                    .member("refused_by", near.refused_by)
                    .end();
            json.end();
        }
        json.array("changes");
        for (const Diagnosis::Change& change : diagnosis.changes) {
            json.object().member("answers", change.answers).member("cost", change.cost);
            if (!change.part.empty()) json.member("part", change.part).member("count", change.count);
            if (!change.lost.empty()) json.member("lost", change.lost);
            json.end();
        }
        json.end().array("counts");
        for (const Diagnosis::Count& count : diagnosis.counts) {
            json.object().member("part", count.part).member("bearers", count.bearers);
            if (count.at_least) json.member("at_least", *count.at_least);
            if (count.at_most) json.member("at_most", *count.at_most);
            json.end();
        }
        json.end().member("counts_are_all", diagnosis.counts_are_all).end();
    }
    json.end();
}

}  // namespace

std::string to_json(const Annotation& annotation) {
    JsonText json(2);
    json.object().object("mesh");
    json.member("file", annotation.mesh_file)
        .member("sha256", annotation.mesh_sha256)
        .member("faces", annotation.mesh_faces)
        .member("triangles", annotation.part_of_triangle.size())
        .member("up", annotation.up)
        .member("up_confidence", annotation.up_confidence)
        .member("unit", annotation.unit)
        .member("unit_confidence", annotation.unit_confidence)
        .member("notes", annotation.mesh_notes)
        .end();
    json.object("ontology")
        .member("iri", annotation.ontology_iri)
        .member("sha256", annotation.ontology_sha256)
        .member("file", annotation.ontology_file)
        .end();
    json.member("strategy", annotation.strategy).object("object");
    json.member("classes", annotation.classes)
        .member("consistent", annotation.consistent)
        .member("score", annotation.score)
        .member("all_classes", annotation.all_classes)
        .member("perhaps", annotation.perhaps)
        .array("nearest");
    for (const NearClass& near : annotation.nearest)
        json.object()
            .member("class", near.concept_name)
            .member("lacks", near.lacks)
            .member("too_many", near.too_many)
            .end();
    json.end().end();
    write_parts(json, annotation);
    write_questions(json, annotation);
    write_knowledge(json, annotation);
    json.member("open_questions", annotation.open_questions).object("timings_ms");
    for (const auto& [stage, ms] : annotation.timings_ms) json.member(stage, ms);
    return json.end().end().text() + "\n";
}

}  // namespace partonomy
