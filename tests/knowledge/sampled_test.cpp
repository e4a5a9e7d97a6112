#include <gtest/gtest.h>

#include "base/errors.h"
#include "brute.h"
#include "knowledge/sampled_models.h"

// A space whose diagram would be too large, against the listed one of the same ontology.

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

CompileOptions sampled() {
    CompileOptions options;
    options.listing_limit = 0;
    options.diagram.node_limit = 0;
    return options;
}

bool is_sampled(const Domain& domain) { return domain.regions.diagram && domain.regions.diagram->sample() != nullptr; }

}  // namespace

TEST(Sampled, KnowsWhatIsPossibleAndInferred) {
    int checked = 0;
    for (unsigned seed = 300; seed < 400; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0);
        Domain a;
        try {
            a = compile(ontology.ontology.result);
        } catch (const OntologyError&) {
            EXPECT_THROW((void)compile(ontology.ontology.result, sampled()), OntologyError);
            continue;
        }
        const Domain b = compile(ontology.ontology.result, sampled());
        if (!is_sampled(b)) continue;  // a diagram without a single node
        ++checked;
        EXPECT_EQ(b.unsatisfiable(), a.unsatisfiable());
        EXPECT_EQ(b.hierarchy(), a.hierarchy());
        EXPECT_EQ(b.regions.all().count_text(), too_many);
        const Knowledge knowledge = brute::random_knowledge(random, ontology);
        const Conclusions x = conclude(a, knowledge), y = conclude(b, knowledge);
        EXPECT_EQ(x.contradiction, y.contradiction);
        EXPECT_EQ(x.diagnoses, y.diagnoses);
        EXPECT_EQ(brute::rows_in(*x.objects, x.object), brute::rows_in(*y.objects, y.object));
        for (std::size_t r = 0; r < x.regions.size(); ++r) {
            EXPECT_EQ(x.regions[r].is_empty(), y.regions[r].is_empty());
            for (std::size_t v = 0; v < a.regions.holds.size(); ++v)
                for (std::size_t k = 0; k < a.regions.holds[v].size(); ++k) {
                    EXPECT_EQ(x.regions[r].intersects(a.regions.holds[v][k]),
                              y.regions[r].intersects(b.regions.holds[v][k]));
                    EXPECT_EQ(x.regions[r].is_subset_of(a.regions.holds[v][k]),
                              y.regions[r].is_subset_of(b.regions.holds[v][k]));
                }
        }
    }
    EXPECT_GT(checked, 40);
}

TEST(Sampled, ChoosesQuestionsThatDecide) {
    int checked = 0;
    for (unsigned seed = 400; seed < 440; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, false);
        Domain domain;
        try {
            domain = compile(ontology.ontology.result, sampled());
        } catch (const OntologyError&) {
            continue;
        }
        if (!is_sampled(domain)) continue;
        PlanOptions options;
        for (std::size_t c = 0; c < domain.regions.concepts.size(); ++c)
            options.wanted.push_back(static_cast<ConceptId>(c));
        const DecisionTree tree = build_tree(domain.regions, options);
        EXPECT_TRUE(tree.is_whole());
        for (const TreeNode& node : tree.nodes)
            EXPECT_EQ(node.question.has_value(), !is_decided(domain.regions, node.configurations, options));
        const DecisionTree again = build_tree(domain.regions, options);
        EXPECT_EQ(to_json(again, domain), to_json(tree, domain)) << "what was asked before plays no role";
        ++checked;
    }
    EXPECT_GT(checked, 15);
}

TEST(Sampled, SaysWhyNothingIsCounted) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Chair", mini::some("hasPart", mini::some("hasShape", "Board")));
    const Domain domain = compile(ontology.result, sampled());
    ASSERT_TRUE(is_sampled(domain));
    ASSERT_EQ(domain.warnings.size(), 1U);
    EXPECT_NE(domain.warnings[0].find("has more than 0 nodes"), std::string::npos) << domain.warnings[0];
    EXPECT_THROW((void)domain.regions.diagram->models(1), std::logic_error);
}
