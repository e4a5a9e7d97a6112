// Inspection of manufactured parts: sound brackets pass, and each defect is named with the region that has it. All 400
// are judged by bench/inspection.py.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

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
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
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
