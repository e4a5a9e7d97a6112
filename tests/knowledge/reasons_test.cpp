#include <gtest/gtest.h>

#include "base/errors.h"
#include "brute.h"

// All explanations and corrections of random small objects against every subset, tried by brute force.

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

unsigned parts_that_matter(const Space& objects) {
    std::map<std::string, unsigned> caps;
    for (const Variable& variable : objects.variables) {
        unsigned& cap = caps[to_manchester(*variable.part_class)];
        cap = std::max(cap, variable.threshold);
    }
    unsigned sum = 0;
    for (const auto& [name, cap] : caps) sum += cap;
    return sum;
}

/// A random object of which some concept follows.
struct Case {
    brute::Random ontology;
    Domain domain;
    Knowledge knowledge;
    int further = 0;  ///< parts that could matter
    Iri goal;

    static std::optional<Case> make(unsigned seed) {
        std::mt19937 random(seed);
        Case made{brute::Random(random, seed % 3 == 0, 2), {}, {}, 0, {}};
        try {
            made.domain = compile(made.ontology.ontology.result);
        } catch (const OntologyError&) {
            return std::nullopt;
        }
        made.further = static_cast<int>(parts_that_matter(made.domain.objects()));
        if (made.further > 3) return std::nullopt;
        made.knowledge = brute::random_knowledge(random, made.ontology);
        const Conclusions conclusions = conclude(made.domain, made.knowledge);
        if (conclusions.contradiction) return std::nullopt;
        const auto classes = entailed(*conclusions.objects, conclusions.object);
        if (classes.empty()) return std::nullopt;
        made.goal = conclusions.objects->concepts[static_cast<std::size_t>(classes[random() % classes.size()])].iri;
        return made;
    }

    /// Whether the goal holds in every object that the axioms, answers and completeness allow.
    [[nodiscard]] bool follows(const std::vector<char>& axioms, const std::vector<char>& answers, bool complete) const {
        bool all = true;
        brute::for_each_object(ontology, knowledge, axioms, answers, complete ? 0 : further,
                               [&](const brute::Classes& each) { all &= each.at(goal); });
        return all;
    }
};

}  // namespace

TEST(Reasons, AllExplanationsAreMinimalAndNoneIsMissing) {
    int checked = 0, sets = 0;
    for (unsigned seed = 5000; seed < 6500 && checked < 6; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto instance = Case::make(seed);
        if (!instance) continue;
        const Explanations found = all_explanations(instance->domain, instance->knowledge, instance->goal);
        ASSERT_TRUE(found.is_complete);
        ASSERT_FALSE(found.sets.empty());
        // Elements: axioms about classes, answers, completeness.
        const std::size_t first = instance->ontology.first_class;
        const std::size_t axioms = instance->domain.ontology.axioms.size() - first;
        const std::size_t answers = instance->knowledge.answers.size();
        const std::size_t n = axioms + answers + (instance->knowledge.complete ? 1 : 0);
        if (n > 9 || instance->further > 1) continue;
        std::set<unsigned> ours;
        for (const Explanation& each : found.sets) {
            unsigned mask = 0;
            for (const std::size_t a : each.axioms) mask |= 1U << (a - first);
            for (const std::size_t a : each.answers) mask |= 1U << (axioms + a);
            if (each.needs_completeness) mask |= 1U << (axioms + answers);
            ours.insert(mask);
        }
        std::set<unsigned> minimal;
        for (unsigned size = 0; size <= n; ++size)
            for (unsigned mask = 0; mask < 1U << n; ++mask) {
                if (static_cast<unsigned>(std::popcount(mask)) != size) continue;
                if (std::ranges::any_of(minimal, [&](unsigned m) { return (m & mask) == m; })) continue;
                std::vector<char> kept(first + axioms, 1), given(answers, 0);
                for (std::size_t i = 0; i < axioms; ++i) kept[first + i] = static_cast<char>(mask >> i & 1U);
                for (std::size_t i = 0; i < answers; ++i) given[i] = static_cast<char>(mask >> (axioms + i) & 1U);
                if (instance->follows(kept, given, (mask >> (axioms + answers) & 1U) != 0)) minimal.insert(mask);
            }
        EXPECT_EQ(ours, minimal);
        ++checked;
        sets += static_cast<int>(minimal.size());
        const Explanation one = explain(instance->domain, instance->knowledge, instance->goal);
        EXPECT_EQ(std::ranges::count(found.sets, one), 1);
    }
    EXPECT_GE(checked, 6);
    EXPECT_GE(sets, checked);
}

TEST(Reasons, CorrectionsAreTheCheapestChanges) {
    int checked = 0, together = 0;
    for (unsigned seed = 6000; seed < 7500 && checked < 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto instance = Case::make(seed);
        if (!instance || instance->knowledge.answers.empty()) continue;
        std::mt19937 random(seed);
        std::vector<double> costs;
        for (std::size_t i = 0; i < instance->knowledge.answers.size(); ++i)
            costs.push_back(static_cast<double>(1 + random() % 50) / 100);
        const auto found = corrections(instance->domain, instance->knowledge, instance->goal, costs);
        // Every set of changes, tried.
        const auto n = instance->knowledge.answers.size();
        std::set<std::vector<std::size_t>> mending;
        for (unsigned mask = 1; mask < 1U << n; ++mask) {
            Knowledge changed = instance->knowledge;
            std::vector<std::size_t> set;
            for (std::size_t i = 0; i < n; ++i)
                if ((mask >> i & 1U) != 0) {
                    changed.answers[i].yes = !changed.answers[i].yes;
                    set.push_back(i);
                }
            const Conclusions conclusions = conclude(instance->domain, changed);
            const Space& objects = *conclusions.objects;
            const ConfigurationSet& where = objects.concepts[*objects.find(instance->goal)].where;
            if (!conclusions.contradiction && !conclusions.object.is_subset_of(where)) mending.insert(set);
        }
        std::set<std::vector<std::size_t>> minimal;
        for (const auto& set : mending)
            if (std::ranges::none_of(mending, [&](const auto& other) {
                    return other.size() < set.size() && std::ranges::includes(set, other);
                }))
                minimal.insert(set);
        std::set<std::vector<std::size_t>> ours;
        for (std::size_t i = 0; i < found.size(); ++i) {
            ours.insert(found[i].answers);
            together += found[i].answers.size() > 1;
            double cost = 0;
            for (const std::size_t a : found[i].answers) cost += costs[a];
            EXPECT_NEAR(found[i].cost, cost, 1e-12);
            if (i > 0) {
                EXPECT_GE(found[i].cost, found[i - 1].cost - 1e-12);
            }
        }
        EXPECT_EQ(ours, minimal);
        ++checked;
    }
    EXPECT_GE(checked, 60);
    EXPECT_GT(together, 0);
}

TEST(Reasons, CorrectionsDoNotLeadIntoAnotherIncompatibility) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("CubeFoot", mini::both({mini::name("Object"), mini::some("hasPart", mini::some("hasShape", "Cube"))}))
        .sub("CubeFoot", "Incompatible")
        .same("StickFoot", mini::both({mini::name("Object"), mini::some("hasPart", mini::some("hasShape", "Stick"))}))
        .sub("StickFoot", "Incompatible");
    const Domain domain = compile(ontology.result);
    // Board: no, Cube: yes, Stick: no. The cheapest way out of the cube alone would be the stick.
    const Knowledge knowledge{1, true, {{0, {0, 0}, false}, {0, {0, 1}, true}, {0, {0, 2}, false}}};
    const auto found = corrections(domain, knowledge, mini::iri("CubeFoot"), {0.4, 0.1, 0.1});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].answers, (std::vector<std::size_t>{0, 1}));
    EXPECT_NEAR(found[0].cost, 0.5, 1e-12);
}

TEST(Reasons, OfOneRegionAndOfContradictions) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("LyingCube", mini::both({mini::some("hasShape", "Cube"), mini::some("hasOrientation", "Horizontal")}))
        .sub("LyingCube", "Incompatible")
        .same("Chair", mini::some("hasPart", "Thing"));
    const Domain domain = compile(ontology.result);
    const Knowledge knowledge{2, false, {{0, {0, 1}, true}, {0, {1, 0}, true}, {1, {0, 1}, true}, {1, {1, 0}, true}}};
    EXPECT_EQ(explain(domain, knowledge, mini::iri("LyingCube"), 1).answers, (std::vector<std::size_t>{2, 3}));
    const auto found = corrections(domain, knowledge, mini::iri("LyingCube"), {0.1, 0.2, 0.3, 0.4}, 1);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].answers, (std::vector<std::size_t>{2}));
    EXPECT_THROW((void)explain(domain, {1, false, {}}, mini::iri("LyingCube")), std::invalid_argument);

    const Knowledge torn{1, false, {{0, {0, 1}, true}, {0, {0, 0}, true}}};
    EXPECT_EQ(all_explanations(domain, torn, "").sets.size(), 1U);
    const auto mended = corrections(domain, torn, "", {0.1, 0.2});
    ASSERT_EQ(mended.size(), 2U);
    EXPECT_EQ(mended[0].answers, (std::vector<std::size_t>{0}));
}
