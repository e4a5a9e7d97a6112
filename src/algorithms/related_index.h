#pragma once

#include <vector>

#include "algorithms/relations.h"

namespace partonomy {

/// TF: finds all regions in relation to given ones, without looking at each.
class RelatedIndex {
public:
    /// Scene and places must outlive it; regions are told by their index in `places`.
    RelatedIndex(const Scene& scene, std::vector<const RegionPlace*> places);

    struct Related {
        int region;
        std::optional<double> score;  ///< as T; nullopt when nothing can tell
    };
    /// All regions that, put in the place of the one -1 in `regions`, may be in the relation: ascending. The score of
    /// all others, but those given, is 0. The target comes first.
    [[nodiscard]] std::vector<Related> find(std::span<const knowledge::Criterion> criteria,
                                            const std::vector<int>& regions) const;

private:
    struct Node {
        Surround surround;
        std::size_t first = 0, last = 0;  ///< regions, in the order of the tree
        std::size_t second = 0;           ///< child; the first one comes right after this node. 0: a leaf
    };
    struct Tree {
        bool by_size;
        std::vector<std::size_t> order;  ///< regions
        std::vector<Node> nodes;
    };
    void build(Tree& tree, std::size_t first, std::size_t last);

    const Scene& scene_;
    std::vector<const RegionPlace*> places_;
    std::vector<Surround> surrounds_;
    Tree by_place_, by_size_;
};

}  // namespace partonomy
