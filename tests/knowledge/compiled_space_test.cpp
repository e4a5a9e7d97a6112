#include <gtest/gtest.h>

#include "base/errors.h"
#include "brute.h"
#include "knowledge/decision_tree.h"

// A compiled space against the listed one of the same ontology; then spaces that no list could hold.

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

CompileOptions compiled() {
    CompileOptions options;
    options.listing_limit = 0;
    return options;
}

void expect_same(const Domain& a, const Domain& b) {
    ASSERT_EQ(a.regions.diagram, nullptr);
    ASSERT_NE(b.regions.diagram, nullptr);
    for (const auto& [x, y] : {std::pair(&a.regions, &b.regions), std::pair(&a.objects(), &b.objects())}) {
        EXPECT_EQ(x->size, y->size);
        EXPECT_EQ(x->product_text(), y->product_text());
        EXPECT_EQ(x->possible.count(), y->possible.count());
        ASSERT_EQ(x->concepts.size(), y->concepts.size());
        for (std::size_t c = 0; c < x->concepts.size(); ++c) {
            EXPECT_EQ(x->concepts[c].where.count_text(), y->concepts[c].where.count_text());
            EXPECT_EQ(x->concepts[c].provable, y->concepts[c].provable) << x->concepts[c].iri;
        }
        ASSERT_EQ(x->variables.size(), y->variables.size());
        for (std::size_t v = 0; v < x->variables.size(); ++v) {
            EXPECT_EQ(x->variables[v].values, y->variables[v].values);
            for (std::size_t k = 0; k < x->holds[v].size(); ++k)
                EXPECT_EQ(x->holds[v][k].count(), y->holds[v][k].count());
        }
    }
    EXPECT_EQ(a.warnings, b.warnings);
    EXPECT_EQ(a.hierarchy(), b.hierarchy());
    EXPECT_EQ(a.unsatisfiable(), b.unsatisfiable());
}

std::string error_of(const owl::Ontology& ontology, const CompileOptions& options) {
    try {
        (void)compile(ontology, options);
    } catch (const OntologyError& error) {
        return error.what();
    }
    return {};
}

std::string numbered(const char* word, int i) {
    std::string name = word;
    name += std::to_string(i);
    return name;
}

/// `features` yes/no features, and rules about a few neighbouring ones each, which one hidden configuration obeys.
mini::Ontology local_rules(unsigned seed, int features, int rules, int window) {
    std::mt19937 random(seed);
    mini::Ontology ontology;
    std::vector<bool> hidden;
    for (int i = 0; i < features; ++i) {
        ontology.range(numbered("F", i), {numbered("yes", i), numbered("no", i)});
        hidden.push_back(random() % 2 == 0);
    }
    const auto has = [&](int feature, bool yes) {
        return mini::some(numbered("hasF", feature), numbered(yes ? "yes" : "no", feature));
    };
    for (int r = 0; r < rules;) {
        const int start = static_cast<int>(random() % static_cast<unsigned>(features - window + 1));
        std::set<int> chosen;
        while (chosen.size() < 4) chosen.insert(start + static_cast<int>(random() % static_cast<unsigned>(window)));
        std::vector<std::pair<int, bool>> terms;
        bool obeyed = false;
        for (const int f : chosen) {
            terms.emplace_back(f, random() % 2 == 0);
            obeyed |= terms.back().second == hidden[static_cast<std::size_t>(f)];
        }
        if (!obeyed) continue;
        ++r;
        // not a and not b -> c or d
        ontology.sub(mini::both({mini::name("Region"), has(terms[0].first, !terms[0].second),
                                 has(terms[1].first, !terms[1].second)}),
                     mini::either({has(terms[2].first, terms[2].second), has(terms[3].first, terms[3].second)}));
    }
    for (int c = 0; c < 5; ++c)
        ontology.same(numbered("Part", c),
                      mini::both({mini::name("Region"), has(3 * c, hidden[static_cast<std::size_t>(3 * c)]),
                                  has(3 * c + 1, hidden[static_cast<std::size_t>(3 * c + 1)])}));
    ontology.same("Pair",
                  mini::both({mini::name("Object"), mini::some("hasPart", "Part0"), mini::some("hasPart", "Part1")}));
    ontology.sub("Odd", "Incompatible");
    ontology.same("Odd", mini::both({mini::name("Object"), mini::some("hasPart", "Part2"),
                                     mini::at_most(0, mini::name("Part3"))}));
    return ontology;
}

}  // namespace

TEST(CompiledSpace, IsTheListedOne) {
    int checked = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0);
        const std::string error = error_of(ontology.ontology.result, {});
        EXPECT_EQ(error_of(ontology.ontology.result, compiled()), error);
        if (!error.empty()) continue;
        const Domain a = compile(ontology.ontology.result), b = compile(ontology.ontology.result, compiled());
        expect_same(a, b);
        ++checked;
        const Knowledge knowledge = brute::random_knowledge(random, ontology);
        const Conclusions x = conclude(a, knowledge), y = conclude(b, knowledge);
        EXPECT_EQ(x.contradiction, y.contradiction);
        EXPECT_EQ(x.diagnoses, y.diagnoses);
        EXPECT_EQ(brute::rows_in(*x.objects, x.object), brute::rows_in(*y.objects, y.object));
        for (std::size_t r = 0; r < x.regions.size(); ++r) EXPECT_EQ(x.regions[r].count(), y.regions[r].count());
        std::vector<Iri> goals;
        for (const ConceptId c : entailed(*x.objects, x.object))
            goals.push_back(x.objects->concepts[static_cast<std::size_t>(c)].iri);
        if (x.contradiction) goals = {Iri{}};
        if (seed % 5 == 0)
            for (const Iri& goal : goals) {
                // Not the same one, perhaps, but one of all that there are.
                const Explanations all = all_explanations(a, knowledge, goal);
                EXPECT_TRUE(all.is_complete);
                EXPECT_EQ(std::ranges::count(all.sets, explain(a, knowledge, goal)), 1);
                EXPECT_EQ(std::ranges::count(all.sets, explain(b, knowledge, goal)), 1);
                EXPECT_EQ(all_explanations(b, knowledge, goal).sets, all.sets);
            }
    }
    EXPECT_GT(checked, 100);
}

TEST(CompiledSpace, WalksTheSameTree) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0);
        if (!error_of(ontology.ontology.result, {}).empty()) continue;
        const Domain a = compile(ontology.ontology.result), b = compile(ontology.ontology.result, compiled());
        for (const SplitCriterion criterion :
             {SplitCriterion::dichotomy, SplitCriterion::entropy, SplitCriterion::gain_per_cost})
            for (const bool all : {false, true}) {
                SCOPED_TRACE("seed " + std::to_string(seed));
                PlanOptions plan;
                plan.criterion = criterion;
                if (!all)
                    for (ConceptId c = 0; c < 3; ++c) plan.wanted.push_back(c);
                EXPECT_EQ(to_json(build_tree(a.regions, plan), a), to_json(build_tree(b.regions, plan), b));
                const auto find_all = [](Question question) {
                    return question.variable == 0 ? std::optional(1.0) : std::nullopt;
                };
                EXPECT_EQ(to_json(build_tree(a.regions, plan, find_all), a),
                          to_json(build_tree(b.regions, plan, find_all), b));
            }
    }
}

TEST(CompiledSpace, NumbersAndConceptsWithoutDefinition) {
    mini::Ontology ontology = mini::shapes();
    ontology.measured("height", "height").measured("width");
    ontology.same("Low", mini::both({mini::name("Region"), mini::number("height", {{"maxInclusive", "0.5"}})}));
    ontology.same("Flat", mini::both({mini::name("Region"), mini::number("height", {{"maxExclusive", "0.2"}}),
                                      mini::number("width", {{"minInclusive", "1"}})}));
    ontology.sub("Leg", "Region").sub(mini::name("Leg"), mini::some("hasShape", "Stick"));
    ontology.sub("Foot", "Region")
        .sub(mini::both({mini::name("Low"), mini::some("hasShape", "Cube")}), mini::name("Foot"));
    ontology.same("Bare", mini::both({mini::name("Region"), mini::name("Leg"), mini::no(mini::name("Foot"))}));
    ontology.same("Either",
                  mini::both({mini::name("Region"), mini::either({mini::name("Leg"), mini::no(mini::name("Leg"))})}));
    ontology.same("Chair", mini::some("hasPart", "Leg"));
    const Domain a = compile(ontology.result), b = compile(ontology.result, compiled());
    expect_same(a, b);
    PlanOptions plan;
    for (ConceptId c = 0; c < static_cast<ConceptId>(a.regions.concepts.size()); ++c) plan.wanted.push_back(c);
    EXPECT_EQ(to_json(build_tree(a.regions, plan), a), to_json(build_tree(b.regions, plan), b));
}

TEST(CompiledSpace, ATrillionConfigurations) {
    const mini::Ontology ontology = local_rules(1, 40, 300, 8);
    const Domain domain = compile(ontology.result);
    ASSERT_NE(domain.regions.diagram, nullptr);
    EXPECT_EQ(domain.regions.product_text(), "1099511627776");
    PlanOptions plan;
    for (ConceptId c = 0; c < static_cast<ConceptId>(domain.regions.concepts.size()); ++c) plan.wanted.push_back(c);
    const Planner planner(domain.regions, plan);
    const auto question = planner.best(domain.regions.all());
    ASSERT_TRUE(question);

    // A region that is a Part2 and no Part3, found out by questions: Odd, as soon as nothing else can turn up.
    const auto where = [&](const char* part) {
        return domain.regions.concepts[static_cast<std::size_t>(*domain.regions.find(mini::iri(part)))].where;
    };
    const ConfigurationSet target = where("Part2") - where("Part3");
    ASSERT_FALSE(target.is_empty());
    Knowledge knowledge{1, true, {}};
    ConfigurationSet set = domain.regions.all();
    for (const char* part : {"Part2", "Part3"})
        while (const auto next = planner.best_about(set, where(part))) {
            const ConfigurationSet yes = yes_set(domain.regions, *next);
            const bool answer = (set & yes).intersects(target);
            if (answer)
                set &= yes;
            else
                set -= yes;
            knowledge.answers.push_back({0, *next, answer});
        }
    EXPECT_TRUE(set.is_subset_of(where("Part2")));
    EXPECT_FALSE(set.intersects(where("Part3")));
    const Conclusions conclusions = conclude(domain, knowledge);
    ASSERT_FALSE(conclusions.contradiction);
    EXPECT_EQ(conclusions.diagnoses, std::vector<Iri>{mini::iri("Odd")});
    const Explanation why = explain(domain, knowledge, mini::iri("Odd"));
    EXPECT_TRUE(why.needs_completeness);
    EXPECT_FALSE(why.answers.empty());
    EXPECT_LE(why.answers.size(), knowledge.answers.size());
    const std::vector<double> costs(knowledge.answers.size(), 0.5);
    for (const Correction& correction : corrections(domain, knowledge, mini::iri("Odd"), costs)) {
        Knowledge changed = knowledge;
        for (const std::size_t i : correction.answers) changed.answers[i].yes = !changed.answers[i].yes;
        EXPECT_TRUE(conclude(domain, changed).diagnoses.empty());
    }
}

TEST(CompiledSpace, AThousandConcepts) {
    const Domain domain = compile(local_rules(1, 1000, 600, 8).result);
    EXPECT_EQ(domain.regions.product_text().size(), 302U);  // 2^1000
    EXPECT_GT(domain.regions.possible.count_text().size(), 200U);
    EXPECT_GT(domain.hierarchy().size(), 3000U);
    EXPECT_TRUE(domain.unsatisfiable().empty());
}

TEST(CompiledSpace, BeyondALimitASolverGoesOn) {
    CompileOptions options;
    options.diagram.node_limit = 10;
    const mini::Ontology ontology = local_rules(3, 40, 300, 8);
    const Domain domain = compile(ontology.result, options), counted = compile(ontology.result);
    ASSERT_FALSE(domain.warnings.empty());
    EXPECT_NE(domain.warnings[0].find("has more than 10 nodes"), std::string::npos) << domain.warnings[0];
    EXPECT_EQ(domain.hierarchy(), counted.hierarchy());
    EXPECT_EQ(domain.unsatisfiable(), counted.unsatisfiable());
}
