#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "expert/annotation.h"
#include "mesh/triangle_mesh.h"

namespace partonomy::zoo {

/// A mesh and what is known about it.
struct Annotated {
    TriangleMesh mesh;
    Annotation annotation;
};

/// Appends a box of six quads (two triangles each, counter-clockwise from outside) that belong to part `part`, or to
/// none.
inline void add_box(Annotated& object, int part, const Vec3& low, const Vec3& high) {
    TriangleMesh& mesh = object.mesh;
    const auto first = static_cast<std::int32_t>(mesh.positions.size());
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                                    (i & 4) != 0 ? high.z() : low.z());
    constexpr std::array<std::array<std::int32_t, 4>, 6> quads{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : quads) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.triangles.push_back({first + a, first + c, first + d});
        mesh.input_faces.insert(mesh.input_faces.end(), 2, mesh.input_face_count++);
        object.annotation.part_of_triangle.insert(object.annotation.part_of_triangle.end(), 2, part);
    }
}

inline void add_part(Annotated& object, const std::vector<std::string>& concepts, double score,
                     const std::string& color) {
    AnnotatedPart part;
    part.id = static_cast<int>(object.annotation.parts.size()) + 1;
    part.concepts = concepts;
    part.score = score;
    part.color = color;
    object.annotation.parts.push_back(part);
}

/// Fills in what follows from the parts' triangles.
inline void complete(Annotated& object) {
    Annotation& annotation = object.annotation;
    const auto faces = static_cast<std::size_t>(object.mesh.input_face_count);
    annotation.mesh_faces = object.mesh.input_face_count;
    annotation.labels.assign(faces, "-");
    annotation.part_of_face.assign(faces, 0);
    annotation.score_of_face.assign(faces, 0);
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        if (annotation.part_of_triangle[t] < 0) continue;
        AnnotatedPart& part = annotation.parts[static_cast<std::size_t>(annotation.part_of_triangle[t])];
        const auto face = static_cast<std::size_t>(object.mesh.input_faces[t]);
        part.triangles.push_back(static_cast<std::int32_t>(t));
        if (annotation.part_of_face[face] == 0) ++part.faces;
        annotation.part_of_face[face] = part.id;
        if (!part.concepts.empty()) annotation.labels[face] = part.concepts.front();
        annotation.score_of_face[face] = static_cast<float>(part.score);
    }
}

/// A bench of four boards, 1.2 x 0.4 x 0.9, z up: seat, backrest, two legs; 24 quads, 48 triangles.
inline Annotated bench(const Vec3& shift = Vec3::Zero()) {
    Annotated object;
    add_part(object, {"Seat", "Support"}, 0.99, "#4e79a7");
    add_part(object, {"Backrest"}, 0.9, "#f28e2b");
    add_part(object, {"Leg"}, 1, "#59a14f");
    add_part(object, {"Leg"}, 0.95, "#e15759");
    add_box(object, 0, Vec3(0, 0, 0.4) + shift, Vec3(1.2, 0.4, 0.45) + shift);
    add_box(object, 1, Vec3(0, 0.35, 0.45) + shift, Vec3(1.2, 0.4, 0.9) + shift);
    add_box(object, 2, Vec3(0, 0, 0) + shift, Vec3(0.06, 0.4, 0.4) + shift);
    add_box(object, 3, Vec3(1.14, 0, 0) + shift, Vec3(1.2, 0.4, 0.4) + shift);
    Annotation& annotation = object.annotation;
    annotation.mesh_file = "bench.off";
    annotation.mesh_sha256 = std::string(64, 'a');
    annotation.ontology_iri = "https://w3id.org/partonomy/furniture";
    annotation.ontology_sha256 = std::string(64, 'b');
    annotation.up = "z";
    annotation.unit = "m";
    annotation.strategy = "expert";
    annotation.classes = {"Bench"};
    annotation.all_classes = {"Bench", "Furniture"};
    annotation.score = 0.9;
    annotation.parts[0].features = {{"Shape", "Board"}, {"Orientation", "Horizontal"}};
    annotation.parts[0].measurements = {{"length", 1.2}, {"width", 0.4}, {"thickness", 0.05}};
    annotation.questions = {{"SF", 1}, {"SI", 2}};
    annotation.trace = {{"SF", "find all Board in the mesh", "mesh", "4 regions", 0.98, {"part 1 is a Seat"}, 1.25},
                        {"SI", "is part 2 Vertical", "part 2", "yes", 1, {}, 0.02}};
    annotation.timings_ms = {{"read", 1.5}, {"ask", 0.25}};
    complete(object);
    return object;
}

/// The bench with a diagnosis against its second leg, and a block that belongs to no part.
inline Annotated broken_bench() {
    Annotated object = bench();
    add_box(object, -1, Vec3(0.4, 0.1, 0.45), Vec3(0.7, 0.3, 0.6));
    object.annotation.consistent = false;
    object.annotation.classes.push_back("FootIncompatibleFurnitures");
    Diagnosis& diagnosis = object.annotation.diagnosis.emplace_back();
    diagnosis.concept_name = "FootIncompatibleFurnitures";
    diagnosis.parts = {4};
    diagnosis.answers = {"part 4 is a Board"};
    diagnosis.axioms = {"Leg SubClassOf: not Board (furniture.ttl:120)"};
    diagnosis.corrections = {"part 4 is a Stick", "part 4 does not exist"};
    object.annotation.open_questions = {"is part 4 Modular: no algorithm answers it"};
    for (AnnotatedPart& part : object.annotation.parts) {
        part.triangles.clear();
        part.faces = 0;
    }
    complete(object);
    return object;
}

/// The bench with composite parts in two layers: its legs, and what one sits on, which holds all but the legs.
inline Annotated made_up_bench() {
    Annotated object = bench();
    object.annotation.composites = {
        {1, {"LegPair"}, {3, 4}, {}}, {2, {"Back"}, {2}, {}}, {3, {"Top", "Upper"}, {1, 2}, {2}}};
    return object;
}

}  // namespace partonomy::zoo
