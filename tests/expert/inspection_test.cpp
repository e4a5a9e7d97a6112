// Inspection of manufactured parts: sound brackets pass, and each defect is named with the region that has it. All 400
// are judged by bench/inspection.py.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "examples/brackets.h"
#include "expert/annotate.h"

namespace partonomy {
namespace {

Annotation inspect(const ExampleObject& part) {
    static const knowledge::Domain domain =
        knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/inspection.omn"));
    static const Catalogue catalogue = make_catalogue(domain);
    return annotate(domain, catalogue, make_object(part.mesh, {}), {});
}

const std::uint32_t seeds = 16;

TEST(Inspection, BracketsAreClosed) {
    for (std::uint32_t seed = 1; seed <= seeds; ++seed)
        for (const std::string& defect : {std::string(), bracket_defects()[seed % bracket_defects().size()]}) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << " " << defect);
            const ExampleObject part = bracket(seed, defect);
            std::map<std::pair<std::int32_t, std::int32_t>, int> ways;
            double volume = 0;
            for (const auto& [a, b, c] : part.mesh.triangles) {
                for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++ways[edge];
                const auto p = [&](std::int32_t v) { return part.mesh.positions[static_cast<std::size_t>(v)]; };
                volume += p(a).dot(p(b).cross(p(c))) / 6;
            }
            EXPECT_GT(volume, 0);
            for (const auto& [edge, count] : ways) {
                EXPECT_EQ(count, 1);
                EXPECT_TRUE(ways.contains({edge.second, edge.first}));
            }
        }
}

TEST(Inspection, SoundPartsPass) {
    std::vector<std::uint32_t> all(seeds);
    std::iota(all.begin(), all.end(), 1U);
    all.push_back(2231);  // what lies between its last hole and the corner of the plate was a part once
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const ExampleObject part = bracket(seed);
        const Annotation annotation = inspect(part);
        EXPECT_EQ(annotation.classes, std::vector<std::string>{"Bracket"});
        EXPECT_TRUE(annotation.consistent);
        std::map<std::string, int> truth, found;
        for (std::size_t t = 0, last = part.mesh.triangles.size(); t < last; ++t)
            if (t == 0 || part.parts[t] != part.parts[t - 1]) ++truth[part.labels[t]];
        for (const AnnotatedPart& each : annotation.parts) ++found[each.concepts.empty() ? "-" : each.concepts.front()];
        EXPECT_EQ(found, truth);
    }
}

/// Each triangle in four, twice; then bent around a level axis below it.
TriangleMesh bent(const TriangleMesh& flat) {
    TriangleMesh mesh = flat;
    for (int round = 0; round < 2; ++round) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto [found, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.positions.size()));
            if (is_new)
                mesh.positions.emplace_back(
                    (mesh.positions[static_cast<std::size_t>(a)] + mesh.positions[static_cast<std::size_t>(b)]) / 2);
            return found->second;
        };
        std::vector<std::array<std::int32_t, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    mesh.input_faces.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.input_faces.push_back(static_cast<std::int32_t>(t));
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    Vec3 low = mesh.positions.front(), high = low;
    for (const Vec3& p : mesh.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double radius = 1.8 * (high.x() - low.x()), middle_x = (low.x() + high.x()) / 2;
    for (Vec3& p : mesh.positions) {
        const double angle = (p.x() - middle_x) / radius, reach = radius + p.z() - low.z();
        p = {reach * std::sin(angle), p.y(), reach * std::cos(angle)};
    }
    return mesh;
}

TEST(Inspection, ABentPlateIsNamed) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        ExampleObject part = bracket(seed);
        part.mesh = bent(part.mesh);
        const Annotation annotation = inspect(part);
        EXPECT_FALSE(std::ranges::count(annotation.classes, "Bracket"));
        const auto named = std::ranges::find(annotation.diagnosis, "BentPlate", &Diagnosis::concept_name);
        ASSERT_NE(named, annotation.diagnosis.end());
        EXPECT_FALSE(named->parts.empty());
    }
}

TEST(Inspection, DefectsAreNamed) {
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        const std::string& defect = bracket_defects()[seed % bracket_defects().size()];
        SCOPED_TRACE(testing::Message() << "seed " << seed << " " << defect);
        const ExampleObject part = bracket(seed, defect);
        const Annotation annotation = inspect(part);
        EXPECT_FALSE(annotation.consistent);
        EXPECT_FALSE(std::ranges::count(annotation.classes, "Bracket"));
        ASSERT_FALSE(annotation.diagnosis.empty());
        for (const Diagnosis& diagnosis : annotation.diagnosis) {
            EXPECT_EQ(diagnosis.concept_name, defect);
            EXPECT_FALSE(diagnosis.parts.empty());
            EXPECT_FALSE(diagnosis.axioms.empty());
            EXPECT_FALSE(diagnosis.corrections.empty());  // as of all that is explained, however many parts there are
            if (defect != "ExtraBoard") continue;
            EXPECT_EQ(diagnosis.parts.size(), 1U);  // the board that is too many, made after the ribs
            std::int32_t last = -1;
            for (std::size_t t = 0; t < part.labels.size(); ++t)
                if (part.labels[t] == "Rib") last = std::max(last, part.parts[t]);
            const AnnotatedPart& blamed = annotation.parts[static_cast<std::size_t>(diagnosis.parts[0] - 1)];
            EXPECT_EQ(part.parts[static_cast<std::size_t>(blamed.triangles.front())], last);
        }
    }
}

}  // namespace
}  // namespace partonomy
