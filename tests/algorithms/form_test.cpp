// Measures of form on parts of shapes and open ones; whole shapes are in concept_cases_test.cpp.

#include "algorithms/form.h"

#include <gtest/gtest.h>

#include "algorithms/catalogue.h"
#include "shape/part_box.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

constexpr double pi = std::numbers::pi;

/// An ontology that speaks of sections and convexity.
struct Knowing {
    knowledge::Domain domain;
    Catalogue catalogue;
    Knowing() {
        std::string text =
            "@prefix : <http://example.org/#> .\n@prefix core: <https://w3id.org/partonomy/core#> .\n"
            "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
            "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
            "<http://example.org/> a owl:Ontology ; owl:imports <https://w3id.org/partonomy/core> .\n";
        const std::vector<std::pair<std::string, std::string>> spoken_of = {{"Section", "Round"},
                                                                            {"Convexity", "Concave"}};
        for (const auto& [range, value] : spoken_of)
            text += ":A" + value + " a owl:Class ; rdfs:subClassOf core:Region ; owl:equivalentClass [ a owl:Class ; " +
                    "owl:intersectionOf ( core:Region [ a owl:Restriction ; owl:onProperty core:has" + range +
                    " ; owl:someValuesFrom core:" + value + " ] ) ] .\n";
        text +=
            ":Thing a owl:Class ; rdfs:subClassOf core:Object ; owl:equivalentClass [ a owl:Class ; owl:intersectionOf "
            "( "
            "core:Object [ a owl:Restriction ; owl:onProperty core:hasPart ; owl:someValuesFrom :ARound ] ) ] .\n";
        domain = knowledge::compile(owl::parse_ontology(text, "form.ttl"));
        catalogue = make_catalogue(domain);
    }
    static const Knowing& get() {
        static const Knowing knowing;
        return knowing;
    }
    [[nodiscard]] knowledge::Question question(const std::string& value) const {
        const auto& variables = domain.regions.variables;
        for (std::size_t v = 0; v < variables.size(); ++v)
            for (std::size_t i = 0; i < variables[v].values.size(); ++i)
                if (variables[v].values[i] == value) return {static_cast<int>(v), static_cast<int>(i)};
        ADD_FAILURE() << "no value " << value;
        return {};
    }
};

/// A mesh, or the triangles that `holds`, as one region.
struct Whole {
    Object object;
    PartRegion part;
    RegionMeasurements measured;
    explicit Whole(
        const TriangleMesh& mesh, double metres = 1,
        const std::function<bool(std::size_t)>& holds = [](std::size_t) { return true; }) {
        object = make_object(mesh, {Vec3::UnitZ(), metres});
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (holds(t)) part.region.triangles.push_back(static_cast<std::int32_t>(t));
        part.region.memberships.assign(part.region.triangles.size(), 1.0F);
        part.box = measure_part(object.mesh, object.geometry, part.region.triangles, object.is_noisy).box;
        measured = measure_region(object, part);
    }
    [[nodiscard]] double score(const std::string& value) const {
        const Knowing& k = Knowing::get();
        return is_a(k.domain, k.catalogue, k.question(value), object, measured).value_or(-1);
    }
};

TriangleMesh pipe(double outer, double inner, double length, double step) {
    return solids::revolve(solids::polygon({{inner, 0}, {outer, 0}, {outer, length}, {inner, length}}, step),
                           static_cast<int>(2 * pi * outer / step), false);
}

/// The inner wall of a pipe is concave, the outer one convex, its end neither.
TEST(Form, WallsOfHolesAreConcave) {
    const TriangleMesh clean = pipe(0.5, 0.3, 0.4, 0.03);
    for (const double noise : {0.0, 0.005})
        for (const unsigned seed : {1U, 2U, 3U}) {
            SCOPED_TRACE(seed);
            std::mt19937 random(seed);
            const TriangleMesh mesh = solids::disturbed(clean, noise, random);
            const auto which = [&](const std::string& wall) {
                return [&, wall](std::size_t t) {
                    double least = 1, most = 0, lowest = 1, highest = 0;
                    for (const std::int32_t v : clean.triangles[t]) {
                        const Vec3& p = clean.positions[static_cast<std::size_t>(v)];
                        least = std::min(least, p.head<2>().norm());
                        most = std::max(most, p.head<2>().norm());
                        lowest = std::min(lowest, p.z());
                        highest = std::max(highest, p.z());
                    }
                    return wall == "inner" ? most < 0.301 : wall == "outer" ? least > 0.499 : lowest > 0.399;
                };
            };
            EXPECT_GT(Whole(mesh, 1, which("inner")).score("Concave"), 0.9);
            EXPECT_GT(Whole(mesh, 1, which("outer")).score("Convex"), 0.9);
            EXPECT_GT(Whole(mesh, 1, which("end")).score("Plane"), noise > 0 ? 0.5 : 0.9);
        }
}

/// How far round a wall goes is counted in whole facets, whatever their number and the noise.
TEST(Form, ArcsOfWholeAndPartialWalls) {
    for (const int around : {24, 36, 64})
        for (const double noise : {0.0, 0.002}) {
            const TriangleMesh clean =
                solids::revolve(solids::polygon({{0.3, 0}, {0.5, 0}, {0.5, 0.4}, {0.3, 0.4}}, 0.05), around, false);
            std::mt19937 random(7);
            const TriangleMesh mesh = solids::disturbed(clean, noise, random);
            for (const double part : {90.0, 180.0, 360.0}) {
                SCOPED_TRACE(std::to_string(around) + " facets, " + std::to_string(part) + " degrees, noise " +
                             std::to_string(noise));
                const Whole wall(mesh, 1, [&](std::size_t t) {
                    double turned = 0;
                    for (const std::int32_t v : clean.triangles[t]) {
                        const Vec3& p = clean.positions[static_cast<std::size_t>(v)];
                        if (p.head<2>().norm() < 0.499) return false;
                        const Vec3 middle = (clean.positions[static_cast<std::size_t>(clean.triangles[t][0])] +
                                             clean.positions[static_cast<std::size_t>(clean.triangles[t][1])] +
                                             clean.positions[static_cast<std::size_t>(clean.triangles[t][2])]) /
                                            3;
                        turned = std::atan2(middle.y(), middle.x()) * 180 / pi;
                    }
                    return (turned < 0 ? turned + 360 : turned) < part;
                });
                EXPECT_NEAR(arc(wall.object, wall.measured), part, 8);
            }
        }
}

TEST(Form, VolumesOfClosedAndOpenShapes) {
    const TriangleMesh stick = solids::sweep(solids::ellipse(0.3, 0.3, 0.02), 2, 0.05);
    const double volume = pi * 0.09 * 2;
    EXPECT_NEAR(enclosed_volume(Whole(stick).object, Whole(stick).measured), volume, 0.01 * volume);
    const auto is_wall = [&](std::size_t t) {
        double lowest = 2, highest = 0;
        for (const std::int32_t v : stick.triangles[t]) {
            lowest = std::min(lowest, stick.positions[static_cast<std::size_t>(v)].z());
            highest = std::max(highest, stick.positions[static_cast<std::size_t>(v)].z());
        }
        return highest > lowest;
    };
    const Whole open(stick, 1, is_wall);
    EXPECT_LT(open.measured.triangles.size(), stick.triangles.size());
    EXPECT_NEAR(enclosed_volume(open.object, open.measured), volume, 0.01 * volume);
    const Whole centimetres(stick, 0.01);
    EXPECT_NEAR(*evaluate(parse_formula("volume"), centimetres.object, centimetres.measured), volume * 1e-6,
                0.01e-6 * volume);
    EXPECT_NEAR(*evaluate(parse_formula("volume / (area * length)"), open.object, open.measured),
                volume / (open.measured.area * open.measured.lengths[0]), 0.01);
}

}  // namespace
}  // namespace partonomy
