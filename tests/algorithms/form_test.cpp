// Every concept of form in core.ttl on shapes of which the answer is known: as they are, and turned about up, scaled
// and with noise.

#include "algorithms/form.h"

#include <gtest/gtest.h>

#include "algorithms/catalogue.h"
#include "shape/part_box.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

using solids::Outline;
constexpr double pi = std::numbers::pi;

/// An ontology that speaks of every further range concept of core.ttl.
struct Knowing {
    knowledge::Domain domain;
    Catalogue catalogue;
    Knowing() {
        std::string text =
            "@prefix : <http://example.org/#> .\n@prefix core: <https://w3id.org/partonomy/core#> .\n"
            "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
            "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
            "<http://example.org/> a owl:Ontology ; owl:imports <https://w3id.org/partonomy/core> .\n";
        const std::vector<std::pair<std::string, std::string>> spoken_of = {
            {"Slope", "Oblique"},          {"Section", "Round"},
            {"Taper", "Tapered"},          {"Bend", "Bent"},
            {"Hollowness", "Hollow"},      {"Symmetry", "MirrorSymmetric"},
            {"Convexity", "Concave"},      {"TurnSymmetry", "TurnSymmetric"},
            {"ModularSeries", "Series43"}, {"SurfaceType", "Cylinder"}};
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

/// A shape and what it is, by concepts; "~Round" means near the border.
struct Known {
    std::string name;
    TriangleMesh mesh;
    std::vector<std::string> is;
};

/// Bends a sweep along z into an arc of `degrees`, towards x.
auto along_arc(double length, double degrees) {
    return [=](double t, const Eigen::Vector2d& p) -> Vec3 {
        const double angle = degrees * pi / 180, radius = length / angle, turn = t * angle;
        return {radius - (radius - p.x()) * std::cos(turn), p.y(), (radius - p.x()) * std::sin(turn)};
    };
}

/// Shrinks a sweep towards its top.
auto shrinking(double length, double to) {
    return [=](double t, const Eigen::Vector2d& p) -> Vec3 {
        const double share = 1 + t * (to - 1);
        return {share * p.x(), share * p.y(), t * length};
    };
}

TriangleMesh pipe(double outer, double inner, double length, double step) {
    return solids::revolve(solids::polygon({{inner, 0}, {outer, 0}, {outer, length}, {inner, length}}, step),
                           static_cast<int>(2 * pi * outer / step), false);
}

std::vector<Known> known_shapes() {
    using namespace solids;
    const double s = 0.06;
    std::vector<Known> all;
    const auto add = [&](const char* name, TriangleMesh mesh, std::vector<std::string> is) {
        all.push_back({name, std::move(mesh), std::move(is)});
    };
    add("square stick", sweep(rectangle(0.5, 0.5, s), 3, s),
        {"Angular", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric", "Convex", "Upright", "Rectangle"});
    add("flat stick", sweep(rectangle(0.7, 0.4, s), 3, s), {"Angular", "Even", "Straight", "Solid"});
    add("round stick", sweep(ellipse(0.3, 0.3, s), 3, s),
        {"Round", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric", "Convex", "Upright", "Cylinder"});
    add("oval stick", sweep(ellipse(0.35, 0.22, s), 3, s), {"Round", "Even", "Straight"});
    add("three-sided stick", sweep(regular(3, 0.4, s), 3, s), {"Angular", "Even", "Straight", "Solid", "Rectangle"});
    add("tapered round stick", sweep(ellipse(0.35, 0.35, s), 3, s, shrinking(3, 0.35)),
        {"Round", "Tapered", "Straight", "Solid", "Cone"});
    add("tapered square stick", sweep(rectangle(0.6, 0.6, s), 3, s, shrinking(3, 0.4)),
        {"Angular", "Tapered", "Straight", "Solid"});
    add("bent round stick", sweep(ellipse(0.18, 0.18, s), 3, s, along_arc(3, 60)), {"Round", "Even", "Bent", "Solid"});
    add("bent square stick", sweep(rectangle(0.35, 0.35, s), 3, s, along_arc(3, 50)),
        {"Angular", "Even", "Bent", "Solid"});
    add("board", sweep(rectangle(2, 1.4, s), 0.2, s),
        {"Angular", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric", "Level", "Rectangle"});
    add("round board", sweep(ellipse(1, 1, s), 0.2, s),
        {"Round", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric", "Level", "Disc"});
    add("bent board", sweep(rectangle(0.15, 1.5, s), 2, s, along_arc(2, 80)), {"Bent", "Even", "MirrorSymmetric"});
    add("board that narrows", sweep(polygon({{-1, -0.8}, {1, -0.25}, {1, 0.25}, {-1, 0.8}}, s), 0.2, s),
        {"Tapered", "Straight", "Solid", "MirrorSymmetric", "TurnAsymmetric", "Level", "Flat"});
    add("lopsided board", sweep(polygon({{-0.9, -0.6}, {1.1, -0.6}, {-0.9, 0.9}}, s), 0.25, s),
        {"Angular", "Straight", "Asymmetric", "TurnAsymmetric", "Flat"});
    add("slanting board", sweep(polygon({{-1, -0.5}, {0.6, -0.5}, {1, 0.5}, {-0.6, 0.5}}, s), 0.25, s),
        {"Straight", "Asymmetric", "TurnSymmetric"});
    add("cube", sweep(rectangle(1, 1, s), 1, s),
        {"Angular", "Even", "Straight", "Solid", "MirrorSymmetric", "Convex", "Rectangle"});
    add("ball", ball(0.6, s),
        {"Round", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric", "Convex", "Sphere"});
    add("ring", torus(0.8, 0.25, s), {"Round", "Even", "Solid", "MirrorSymmetric", "TurnSymmetric", "Torus"});
    add("pipe", pipe(0.5, 0.42, 2, 0.04),
        {"Round", "Even", "Straight", "Hollow", "MirrorSymmetric", "TurnSymmetric", "Cylinder"});
    add("blob",
        moved(ball(0.6, s),
              [](const Vec3& p) -> Vec3 {
                  return p * (1 + 0.25 * std::sin(5 * p.x() + 1) * std::cos(6 * p.y()) + 0.2 * std::sin(7 * p.z()));
              }),
        {"Freeform", "Solid"});
    add("slab on edge, tilted", tilted(sweep(rectangle(0.2, 1.2, s), 1.6, s), 45), {"Oblique", "Solid", "Straight"});
    add("leaning stick", tilted(sweep(rectangle(0.3, 0.3, s), 2.5, s), 35), {"Oblique", "Straight"});
    add("stick that hardly leans", tilted(sweep(rectangle(0.3, 0.3, s), 2.5, s), 8), {"Upright"});
    return all;
}

/// Other values of the same range concept.
std::vector<std::string> others(const std::string& value) {
    const Knowing& k = Knowing::get();
    std::vector<std::string> values =
        k.domain.regions.variables[static_cast<std::size_t>(k.question(value).variable)].values;
    std::erase(values, value);
    return values;
}

TEST(Form, KnownShapesAreWhatTheyAreAndNothingElse) {
    for (const Known& shape : known_shapes()) {
        SCOPED_TRACE(shape.name);
        const Whole whole(shape.mesh);
        for (const std::string& value : shape.is) {
            EXPECT_GT(whole.score(value), 0.9) << value;
            for (const std::string& other : others(value)) EXPECT_LT(whole.score(other), 0.1) << other;
        }
    }
}

TEST(Form, NoiseSizeAndTurningChangeNothing) {
    for (const Known& shape : known_shapes())
        for (const unsigned seed : {1U, 2U}) {
            SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            const Whole whole(solids::disturbed(shape.mesh, 0.005, random));
            for (const std::string& value : shape.is) {
                EXPECT_GT(whole.score(value), 0.5) << value;
                for (const std::string& other : others(value)) EXPECT_LT(whole.score(other), 0.5) << other;
            }
        }
}

/// Half way between two values, each is about as likely as the other.
TEST(Form, BordersAreBorders) {
    using namespace solids;
    const double s = 0.06;
    const std::vector<Known> borders = {
        {"stick at 15 degrees", tilted(sweep(rectangle(0.3, 0.3, s), 2.5, s), 75), {"Level", "Oblique"}},
        {"stick at 75 degrees", tilted(sweep(rectangle(0.3, 0.3, s), 2.5, s), 15), {"Upright", "Oblique"}},
        {"stick that narrows a little", sweep(rectangle(0.5, 0.5, s), 3, s, shrinking(3, 0.71)), {"Even", "Tapered"}},
        {"stick that bends a little", sweep(rectangle(0.3, 0.3, s), 3, s, along_arc(3, 30)), {"Straight", "Bent"}},
        {"five-sided stick", sweep(regular(5, 0.35, s), 3, s), {"Round", "Angular"}},
        {"thick pipe", pipe(0.5, 0.15, 2, 0.05), {"Hollow", "Solid"}},
        {"nearly a rectangle",
         sweep(polygon({{-1, -0.5}, {0.8, -0.5}, {1, 0.5}, {-0.8, 0.5}}, s), 0.25, s),
         {"MirrorSymmetric", "Asymmetric"}},
    };
    for (const Known& shape : borders) {
        SCOPED_TRACE(shape.name);
        const Whole whole(shape.mesh);
        for (const std::string& value : shape.is) EXPECT_NEAR(whole.score(value), 0.5, 0.42) << value;
    }
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

TEST(Form, HeightsOfTheModularSeries) {
    const std::vector<int> heights = {27, 43, 70, 86, 113, 140, 183, 226};
    for (std::size_t i = 0; i < heights.size(); ++i) {
        SCOPED_TRACE(heights[i]);
        const double h = heights[i] / 100.0;
        const auto series = [](int height) { return "Series" + std::to_string(height); };
        for (const double metres : {1.0, 0.01}) {
            const Whole whole(
                solids::sweep(solids::rectangle(0.1 / metres, 0.1 / metres, 1 / metres), h / metres, 0.2 / metres),
                metres);
            for (const int other : heights) EXPECT_EQ(whole.score(series(other)), other == heights[i] ? 1 : 0) << other;
        }
        if (i + 1 == heights.size()) continue;
        const double between = (h + heights[i + 1] / 100.0) / 2;
        const Whole whole(solids::sweep(solids::rectangle(0.1, 0.1, 1), between, 0.2));
        EXPECT_NEAR(whole.score(series(heights[i])), 0.5, 0.1);
        EXPECT_NEAR(whole.score(series(heights[i + 1])), 0.5, 0.1);
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
