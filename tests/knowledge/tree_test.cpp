#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "brute.h"
#include "knowledge/decision_tree.h"

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

/// A space with the given numbers of values, and random concepts over it.
Space random_space(std::mt19937& random, const std::vector<std::size_t>& values, std::size_t concepts) {
    Space space;
    space.size = 1;
    for (const std::size_t n : values) space.size *= n;
    space.product = space.size;
    std::size_t run = space.size;
    for (const std::size_t n : values) {
        run /= n;
        Variable variable{};
        variable.kind = VariableKind::range;
        variable.iri = "urn:v" + std::to_string(space.variables.size());
        std::vector<ConfigurationSet> holds(n, ConfigurationSet(space.size));
        for (std::size_t i = 0; i < space.size; ++i) holds[i / run % n].insert(i);
        variable.values.resize(n);
        space.variables.push_back(variable);
        space.holds.push_back(holds);
    }
    space.possible = space.all();
    for (std::size_t c = 0; c < concepts; ++c) {
        // a conjunction or disjunction of two values: what ontologies look like
        const auto pick = [&] {
            const std::size_t v = random() % values.size();
            return space.holds[v][random() % values[v]];
        };
        const ConfigurationSet a = pick(), b = pick();
        space.concepts.push_back({"urn:c" + std::to_string(c), random() % 2 ? a & b : a | b, false, true});
    }
    return space;
}

std::vector<ConceptId> all_concepts(const Space& space) {
    std::vector<ConceptId> ids;
    for (std::size_t i = 0; i < space.concepts.size(); ++i) ids.push_back(static_cast<ConceptId>(i));
    return ids;
}

/// Follows one configuration down to its leaf; the number of questions on the way.
std::size_t walk(const DecisionTree& tree, std::size_t configuration, int& leaf) {
    std::size_t questions = 0;
    int at = 0;
    while (tree.nodes[static_cast<std::size_t>(at)].question) {
        const TreeNode& node = tree.nodes[static_cast<std::size_t>(at)];
        EXPECT_TRUE(node.configurations.has(configuration));
        at = yes_set(*tree.space, *node.question).has(configuration) ? node.yes : node.no;
        ++questions;
    }
    leaf = at;
    EXPECT_TRUE(tree.nodes[static_cast<std::size_t>(at)].configurations.has(configuration));
    return questions;
}

/// Fewest questions in all, over the configurations of the set, by trying everything.
std::size_t optimum(const Space& space, const ConfigurationSet& set, const PlanOptions& options,
                    std::map<ConfigurationSet, std::size_t>& known) {
    if (is_decided(space, set, options)) return 0;
    if (const auto found = known.find(set); found != known.end()) return found->second;
    std::size_t best = SIZE_MAX;
    for (std::size_t v = 0; v < space.variables.size(); ++v)
        for (std::size_t k = 0; k < space.holds[v].size(); ++k) {
            const ConfigurationSet yes = set & space.holds[v][k];
            if (yes.is_empty() || yes == set) continue;
            best = std::min(
                best, set.count() + optimum(space, yes, options, known) + optimum(space, set - yes, options, known));
        }
    return known[set] = best;
}

}  // namespace

TEST(Tree, LeavesCoverTheSpaceAndDecide) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Space space = random_space(random, {3, 2, 2, 3}, 4);
        for (const SplitCriterion criterion : {SplitCriterion::dichotomy, SplitCriterion::gain_per_cost})
            for (const bool wanted : {false, true}) {
                PlanOptions options{criterion, {}, wanted ? all_concepts(space) : std::vector<ConceptId>{}};
                const DecisionTree tree = build_tree(space, options);
                std::set<ConfigurationSet> sets;
                std::size_t covered = 0;
                for (const TreeNode& node : tree.nodes) {
                    EXPECT_TRUE(sets.insert(node.configurations).second) << "equal sets share a node";
                    EXPECT_EQ(node.question.has_value(), !is_decided(space, node.configurations, options));
                    if (!node.question) covered += node.configurations.count();
                }
                EXPECT_EQ(covered, space.size);
                std::size_t longest = 0;
                for (std::size_t i = 0; i < space.size; ++i) {
                    int leaf = -1;
                    longest = std::max(longest, walk(tree, i, leaf));
                    for (const ConceptId c : tree.nodes[static_cast<std::size_t>(leaf)].asserted)
                        EXPECT_TRUE(space.concepts[static_cast<std::size_t>(c)].where.has(i));
                }
                EXPECT_EQ(longest, tree.depth());
            }
    }
}

TEST(Tree, NearTheFewestQuestions) {
    double ours = 0, best = 0, by_dichotomy = 0;
    for (unsigned seed = 100; seed < 130; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Space space = random_space(random, {3, 2, 2, 2}, 3);
        PlanOptions options{SplitCriterion::gain_per_cost, {}, all_concepts(space)};
        std::map<ConfigurationSet, std::size_t> known;
        const std::size_t fewest = optimum(space, space.all(), options, known);
        const auto total = [&] {
            const DecisionTree tree = build_tree(space, options);
            std::size_t sum = 0;
            int leaf = 0;
            for (std::size_t i = 0; i < space.size; ++i) sum += walk(tree, i, leaf);
            return sum;
        };
        const std::size_t by_gain = total();
        options.criterion = SplitCriterion::dichotomy;
        by_dichotomy += static_cast<double>(total());
        EXPECT_GE(by_gain, fewest);
        EXPECT_LE(static_cast<double>(by_gain), 1.5 * static_cast<double>(fewest));
        ours += static_cast<double>(by_gain);
        best += static_cast<double>(fewest);
    }
    EXPECT_LE(ours, 1.1 * best);
    EXPECT_LE(ours, by_dichotomy);
    RecordProperty("gain_over_optimum", std::to_string(ours / best));
    RecordProperty("dichotomy_over_optimum", std::to_string(by_dichotomy / best));
}

TEST(Tree, StopsWhenWantedIsDecided) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Seat", mini::some("hasShape", "Board")).same("Chair", mini::some("hasPart", "Seat"));
    const Domain domain = compile(ontology.result);
    PlanOptions options;
    options.wanted = {*domain.regions.find(mini::iri("Seat"))};
    const DecisionTree tree = build_tree(domain.regions, options);
    ASSERT_EQ(tree.nodes.size(), 3U);  // is it a Board; nothing else matters
    EXPECT_EQ(to_text(domain.regions, *tree.nodes[0].question, domain), "is it a Board");
    EXPECT_EQ(tree.nodes[1].asserted, options.wanted);
    EXPECT_EQ(tree.nodes[2].excluded, options.wanted);
}

TEST(Tree, AnExclusiveOrIsStillDecided) {
    std::mt19937 random(1);
    Space space = random_space(random, {2, 2}, 0);
    space.concepts.push_back(
        {"urn:xor", (space.holds[0][0] & space.holds[1][0]) | (space.holds[0][1] & space.holds[1][1]), false, true});
    PlanOptions options;
    options.wanted = {0};
    EXPECT_EQ(build_tree(space, options).depth(), 2U);
}

TEST(Tree, CostsAndUnaskableQuestions) {
    std::mt19937 random(1);
    const Space space = random_space(random, {2, 2}, 0);
    PlanOptions options;
    options.cost = [](Question question) -> std::optional<double> { return question.variable == 0 ? 3.0 : 1.0; };
    EXPECT_EQ(best_question(space, space.all(), options)->variable, 1);
    options.cost = [](Question question) -> std::optional<double> {
        return question.variable == 0 ? std::optional(3.0) : std::nullopt;
    };
    const DecisionTree tree = build_tree(space, options);
    EXPECT_EQ(tree.nodes.size(), 3U);  // the second variable stays open
    EXPECT_EQ(tree.nodes[1].configurations.count(), 2U);
    TreeLimits two;
    two.nodes = 2;
    EXPECT_THROW((void)build_tree(space, {}, {}, two), OntologyError);
}

TEST(Tree, ImpossibleConfigurationsAreAskedLast) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Seat", mini::some("hasShape", "Board"))
        .same("Bad", mini::both({mini::some("hasShape", "Board"), mini::some("hasOrientation", "Vertical")}))
        .sub("Bad", "Incompatible")
        .same("Chair", mini::some("hasPart", "Seat"));
    const Domain domain = compile(ontology.result);
    PlanOptions options;
    options.wanted = all_concepts(domain.regions);
    const ConfigurationSet boards = domain.regions.holds[0][0];
    const auto question = best_question(domain.regions, boards, options);  // decided among the possible ones
    ASSERT_TRUE(question);
    EXPECT_EQ(question->variable, 1);
}

TEST(Tree, FindAllComesFirstAndCutsEverything) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Seat", mini::some("hasOrientation", "Horizontal")).same("Chair", mini::some("hasPart", "Seat"));
    const Domain domain = compile(ontology.result);
    PlanOptions options;
    options.criterion = SplitCriterion::dichotomy;
    const DecisionTree tree = build_tree(domain.regions, options, [](Question question) -> std::optional<double> {
        return question.variable == 0 ? std::optional(1.0) : std::nullopt;
    });
    int at = 0;
    for (const int value : {0, 1, 2}) {  // boards, then cubes, then what must be sticks
        const TreeNode& node = tree.nodes[static_cast<std::size_t>(at)];
        EXPECT_FALSE(node.segmented);
        ASSERT_TRUE(node.question);
        EXPECT_EQ(*node.question, (Question{0, value}));
        EXPECT_TRUE(tree.nodes[static_cast<std::size_t>(node.yes)].segmented);
        EXPECT_EQ(tree.nodes[static_cast<std::size_t>(node.yes)].question->variable, 1);
        at = node.no;
    }
    EXPECT_EQ(at, -1);
}

TEST(Tree, Files) {
    mini::Ontology ontology = mini::shapes();
    ontology.measured("height", "top height")
        .same("Seat", mini::both({mini::some("hasShape", "Board"), mini::number("height", {{"maxInclusive", "0.55"}})}))
        .same("Chair", mini::both({mini::some("hasPart", "Seat"), mini::at_least(3, mini::some("hasShape", "Stick"))}));
    const Domain domain = compile(ontology.result);
    PlanOptions options;
    options.wanted = all_concepts(domain.regions);
    const DecisionTree tree = build_tree(domain.regions, options);
    const auto json = nlohmann::json::parse(to_json(tree, domain));
    EXPECT_EQ(json["format"], "partonomy decision tree 1");
    EXPECT_EQ(json["configurations"], 12);
    EXPECT_EQ(json["nodes"].size(), tree.nodes.size());
    EXPECT_EQ(json["nodes"][0]["configurations"], 12);
    const int yes = json["nodes"][0]["yes"];
    EXPECT_TRUE(json["nodes"][yes]["told"].size() + json["nodes"][yes]["inferred"].size() > 0);
    EXPECT_EQ(to_json(tree, domain), to_json(build_tree(domain.regions, options), domain));
    const std::string dot = to_dot(tree, domain);
    EXPECT_NE(dot.find("is it a Board?"), std::string::npos);
    EXPECT_NE(dot.find("height &lt;= 0.55?"), std::string::npos);
    EXPECT_EQ(to_text(domain.objects(), {1, 0}, domain), "has it at least 3 (hasShape some Stick)");
}

TEST(Tree, IsLeftOpenBeyondALimit) {
    mini::Ontology ontology = mini::shapes();
    ontology.range("Size", {"Small", "Large"}).same("Chair", mini::some("hasPart", "Thing"));
    const Domain domain = compile(ontology.result);
    const DecisionTree whole = build_tree(domain.regions, {});
    EXPECT_TRUE(whole.is_whole());
    TreeLimits limits;
    limits.leave_open = true;
    limits.depth = 1;
    const DecisionTree shallow = build_tree(domain.regions, {}, {}, limits);
    EXPECT_EQ(shallow.depth(), 1U);
    EXPECT_EQ(shallow.nodes.size(), 3U);
    EXPECT_FALSE(shallow.is_whole());
    EXPECT_EQ(shallow.nodes[1].question, whole.nodes[1].question);
    EXPECT_TRUE(nlohmann::json::parse(to_json(shallow, domain))["nodes"][1]["open"]);
    limits.depth = 100;
    for (std::size_t most = 1; most < whole.nodes.size(); ++most) {
        limits.nodes = most;
        const DecisionTree part = build_tree(domain.regions, {}, {}, limits);
        EXPECT_LE(part.nodes.size(), most);
        EXPECT_FALSE(part.is_whole());
    }
    limits.nodes = whole.nodes.size() + 1;  // a node is left open when its two children might not find room
    EXPECT_EQ(to_json(build_tree(domain.regions, {}, {}, limits), domain), to_json(whole, domain));
}

TEST(Tree, Pictures) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Seat", mini::some("hasShape", "Board")).same("Chair", mini::some("hasPart", "Seat"));
    const Domain domain = compile(ontology.result);
    const DecisionTree tree = build_tree(domain.regions, {});
    const std::string svg = to_svg(tree, domain);
    const auto count = [](const std::string& text, const std::string& word) {
        std::size_t n = 0;
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
        return n;
    };
    EXPECT_TRUE(svg.starts_with("<svg ")) << svg;
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(count(svg, "<rect x="), tree.nodes.size());
    EXPECT_EQ(count(svg, "<path "),
              std::size_t(std::ranges::count_if(tree.nodes, [](const TreeNode& node) { return node.yes >= 0; })) * 2);
    EXPECT_NE(svg.find("is it a Board?"), std::string::npos);
    const std::string html = to_html(tree, domain);
    const std::size_t begin = html.find("id=\"data\">") + 10, end = html.find("</script>", begin);
    EXPECT_EQ(nlohmann::json::parse(html.substr(begin, end - begin)), nlohmann::json::parse(to_json(tree, domain)));
    EXPECT_EQ(html.find("http"), html.find("http", begin)) << "nothing is fetched from elsewhere";
}
