#include "knowledge/relations.h"

#include <algorithm>

// Relations between regions, as the N-ary Relation pattern has them (paper §3.2.2): a node of a relation for each tuple
// of regions that is in it, so
//
//     isTargetRegion some (UpFrom and inverse isReferenceRegion some Seat)
//
// says "among the nodes that have me as their target, one is of UpFrom and has a Seat as its reference". In a region's
// space that is one more feature, yes or no (region_space.cpp): the restriction as a whole is what the planner asks
// for. Its answer is found here, from T on single tuples and from what is known of the other regions; three truth
// values are enough, since a test only counts: what is open stays open, and nothing is guessed. A test that is true
// whatever an open region is ("a Seat or no Seat") may stay open as well; asking on settles it.
//
// Cost: (nodes a region may be in) = n - 1 for two regions, n² / 2 for three; T only for those that may pass.

namespace partonomy::knowledge {
namespace {

Truth negated(Truth a) { return a == Truth::open ? a : a == Truth::yes ? Truth::no : Truth::yes; }

Truth membership(const ConfigurationSet& region, const ConfigurationSet& where) {
    if (region.is_empty()) return Truth::open;
    return region.is_subset_of(where) ? Truth::yes : region.intersects(where) ? Truth::open : Truth::no;
}

/// `is_in(part class, i)`: of the i-th region of the node, 0 being the target.
template <typename IsIn>
Truth evaluate_test(const NodeTest& test, std::size_t relation, std::size_t arity, const IsIn& is_in) {
    const auto again = [&](const NodeTest& operand) { return evaluate_test(operand, relation, arity, is_in); };
    switch (test.kind) {
        case NodeTest::Kind::relation:
            return test.relations[relation] ? Truth::yes : Truth::no;
        case NodeTest::Kind::target:
            return test.threshold > 1 ? Truth::no : is_in(test.part_class, std::size_t{0});
        case NodeTest::Kind::references: {
            unsigned sure = 0, may_be = 0;
            for (std::size_t i = 1; i < arity; ++i) {
                const Truth truth = is_in(test.part_class, i);
                sure += truth == Truth::yes;
                may_be += truth != Truth::no;
            }
            return sure >= test.threshold ? Truth::yes : may_be >= test.threshold ? Truth::open : Truth::no;
        }
        case NodeTest::Kind::no:
            return negated(again(test.operands[0]));
        case NodeTest::Kind::all: {
            Truth least = Truth::yes;
            for (const NodeTest& operand : test.operands) least = std::min(least, again(operand));
            return least;
        }
        case NodeTest::Kind::any:
            break;
    }
    Truth most = Truth::no;
    for (const NodeTest& operand : test.operands) most = std::max(most, again(operand));
    return most;
}

/// Every node that the region may be in, in its role.
std::vector<RelationTuple> nodes_of(const Domain& domain, const RelationalFeature& feature, int region, int count) {
    std::vector<RelationTuple> nodes;
    for (std::size_t r = 0; r < domain.relations.size(); ++r) {
        if (!may_pass(feature.test, domain.relations, r)) continue;
        const bool binary = domain.relations[r].arity == 2;
        for (int a = 0; a < count; ++a) {
            if (a == region) continue;
            if (binary) {
                nodes.push_back({r, feature.of_target ? std::vector{region, a} : std::vector{a, region}});
                continue;
            }
            for (int b = feature.of_target ? a + 1 : 0; b < count; ++b) {
                if (b == region || b == a) continue;
                if (feature.of_target)
                    nodes.push_back({r, {region, a, b}});
                else
                    nodes.push_back({r, {a, std::min(b, region), std::max(b, region)}});
            }
        }
    }
    return nodes;
}

}  // namespace

bool may_pass(const NodeTest& test, const std::vector<Relation>& relations, std::size_t relation) {
    const auto anything = [](std::size_t, std::size_t) { return Truth::open; };
    return evaluate_test(test, relation, relations[relation].arity, anything) != Truth::no;
}

Truth passes(const RelationalFeature& feature, const RelationTuple& node,
             const std::vector<ConfigurationSet>& regions) {
    return evaluate_test(feature.test, node.relation, node.regions.size(), [&](std::size_t part_class, std::size_t i) {
        return membership(regions[static_cast<std::size_t>(node.regions[i])], feature.classes[part_class]);
    });
}

std::vector<std::pair<Truth, RelationTuple>> nodes_in_question(const Domain& domain, const RelationalFeature& feature,
                                                               int region,
                                                               const std::vector<ConfigurationSet>& regions) {
    std::vector<std::pair<Truth, RelationTuple>> nodes;
    for (RelationTuple& node : nodes_of(domain, feature, region, static_cast<int>(regions.size())))
        if (const Truth truth = passes(feature, node, regions); truth != Truth::no)
            nodes.emplace_back(truth, std::move(node));
    std::ranges::stable_sort(nodes, std::greater<>{}, &std::pair<Truth, RelationTuple>::first);
    return nodes;
}

RelationAnswer answer_relation(const Domain& domain, const RelationalFeature& feature, int region,
                               const std::vector<ConfigurationSet>& regions, bool complete,
                               const std::function<std::optional<double>(const RelationTuple&)>& score) {
    const auto nodes = nodes_in_question(domain, feature, region, regions);
    std::vector<double> proving;
    double excluded = 1;
    std::size_t open = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::optional<double> found = score(nodes[i].second);
        if (!found) {
            ++open;
        } else if (*found < 0.5) {
            excluded = std::min(excluded, 1 - *found);
        } else if (nodes[i].first == Truth::yes) {
            proving.push_back(*found);
        } else {
            ++open;
        }
        if (proving.size() >= feature.threshold) return {Truth::yes, *std::min_element(proving.begin(), proving.end())};
        if (!complete && i + 1 < nodes.size() && nodes[i + 1].first == Truth::open) break;  // nothing more can be told
    }
    if (complete && proving.size() + open < feature.threshold) return {Truth::no, excluded};
    return {};
}

}  // namespace partonomy::knowledge
