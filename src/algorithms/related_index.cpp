/* TF (paper §3.4.1): which regions are in a relation to these.
 *
 * Regions are leaves of a tree of boxes, halved at the median along the side where their middles are spread most; a
 * second tree is halved by the sides of the regions themselves, for relations that look at sizes only. From the root
 * down, each measure of the relation tells between which numbers its value lies for all regions below
 * (RelationMeasure:: range); where a trapezoid is 0 on all of them, the branch is left, and where all are 1 there, all
 * regions below it are found. What remains is asked by T. So TF tells exactly what asking T of everybody would tell: no
 * region that T scores above 0 is lost.
 *
 * Cost: O(n log n) to build; then what is found, and T for what is near its border. Relations without a range
 * (parallel, orthogonal) ask everybody; they compare two directions only. */

#include "algorithms/related_index.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace partonomy {
namespace {

constexpr std::size_t leaf_size = 4;

Vec3 key_of(const Surround& surround, bool by_size) {
    return by_size ? surround.size_from : Vec3((surround.low_from + surround.high_from) / 2);
}

}  // namespace

RelatedIndex::RelatedIndex(const Scene& scene, std::vector<const RegionPlace*> places)
    : scene_(scene), places_(std::move(places)), by_place_{false, {}, {}}, by_size_{true, {}, {}} {
    for (const RegionPlace* place : places_) surrounds_.push_back(surround_of(*place));
    for (Tree* tree : {&by_place_, &by_size_}) {
        tree->order.resize(places_.size());
        std::iota(tree->order.begin(), tree->order.end(), 0);
        if (!places_.empty()) build(*tree, 0, places_.size());
    }
}

void RelatedIndex::build(Tree& tree, std::size_t first, std::size_t last) {
    const std::size_t index = tree.nodes.size();
    Node node{surrounds_[tree.order[first]], first, last, 0};
    Vec3 low = key_of(node.surround, tree.by_size), high = low;
    for (std::size_t i = first; i < last; ++i) {
        const Surround& each = surrounds_[tree.order[i]];
        enclose(node.surround, each);
        low = low.cwiseMin(key_of(each, tree.by_size));
        high = high.cwiseMax(key_of(each, tree.by_size));
    }
    tree.nodes.push_back(node);
    if (last - first <= leaf_size) return;
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const auto at = [&](std::size_t i) { return tree.order.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t half = first + (last - first) / 2;
    std::nth_element(at(first), at(half), at(last), [&](std::size_t a, std::size_t b) {
        const double x = key_of(surrounds_[a], tree.by_size)[axis], y = key_of(surrounds_[b], tree.by_size)[axis];
        return std::pair(x, a) < std::pair(y, b);
    });
    build(tree, first, half);
    const std::size_t second = tree.nodes.size();
    build(tree, half, last);
    tree.nodes[index].second = second;
}

std::vector<RelatedIndex::Related> RelatedIndex::find(std::span<const knowledge::Criterion> criteria,
                                                      const std::vector<int>& regions) const {
    std::vector<Related> found;
    if (places_.empty()) return found;
    const auto open = static_cast<std::size_t>(std::ranges::find(regions, -1) - regions.begin());
    std::vector<const RegionPlace*> tuple;
    std::vector<const Surround*> surrounds;
    for (const int region : regions) {
        tuple.push_back(region < 0 ? nullptr : places_[static_cast<std::size_t>(region)]);
        surrounds.push_back(region < 0 ? nullptr : &surrounds_[static_cast<std::size_t>(region)]);
    }
    const RelationTest test(criteria);
    const Tree& tree = test.looks_at_sizes_only() ? by_size_ : by_place_;
    std::vector<std::size_t> waiting{0};
    while (!waiting.empty()) {
        const std::size_t index = waiting.back();
        const Node& node = tree.nodes[index];
        waiting.pop_back();
        surrounds[open] = &node.surround;
        const RelationTest::Prospect prospect = test.prospect(scene_, surrounds);
        if (prospect == RelationTest::Prospect::none) continue;
        if (node.second != 0 && prospect == RelationTest::Prospect::open) {
            waiting.push_back(node.second);
            waiting.push_back(index + 1);
            continue;
        }
        for (std::size_t i = node.first; i < node.last; ++i) {
            const auto region = static_cast<int>(tree.order[i]);
            if (std::ranges::find(regions, region) != regions.end()) continue;
            tuple[open] = places_[tree.order[i]];
            surrounds[open] = &surrounds_[tree.order[i]];
            const std::optional<double> score = prospect == RelationTest::Prospect::sure
                                                    ? std::optional<double>(1)
                                                    : test.score(scene_, tuple, surrounds);
            if (!score || *score > 0) found.push_back({region, score});
        }
    }
    std::ranges::sort(found, {}, &Related::region);
    return found;
}

}  // namespace partonomy
