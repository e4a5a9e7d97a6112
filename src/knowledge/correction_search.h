#pragma once

#include "knowledge/explain.h"
#include "knowledge/object_test.h"

namespace partonomy::knowledge {

/// Corrections (see explain.h) of a listed space, by trying sets of answers in the order of what they cost.
class CorrectionSearch {
public:
    /// Throws std::invalid_argument when there is nothing to correct. All arguments must outlive it.
    CorrectionSearch(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                     const std::vector<double>& costs, int region);

    /// At most `limit` corrections.
    [[nodiscard]] std::vector<Correction> run(std::size_t limit);
    /// Whether the last run stopped before it had tried all sets or found `limit`.
    [[nodiscard]] bool is_cut_short() const { return is_cut_short_; }

private:
    /// What an object must not be, now or after a change.
    struct Unwanted {
        std::vector<ConfigurationSet> regions = {};                 ///< by region
        std::vector<Iri> objects = {};                              ///< concepts of the object
        std::vector<Iri> concepts = {};                             ///< that no composite part must be
        std::optional<ObjectTest> test = {};                        ///< about `objects`, where it can tell
        std::vector<ObjectTest::Types> types = {};                  ///< for the test, by region; 0 as types_now() says
        std::vector<std::optional<ObjectTest::Types>> turned = {};  ///< by answer: of its region with it alone turned
    };
    [[nodiscard]] Unwanted with_test(Unwanted unwanted, const Conclusions& known) const;
    [[nodiscard]] bool mends(const std::vector<std::size_t>& set, Unwanted& unwanted);
    [[nodiscard]] bool mends_by_test(const std::vector<std::size_t>& set, Unwanted& unwanted) const;
    /// Of a region with the answers as they are turned; 0 when they contradict each other or make it what it must not
    /// be.
    [[nodiscard]] ObjectTest::Types types_now(int region, const Unwanted& unwanted) const;
    [[nodiscard]] bool mends_by_conclusions(const Unwanted& unwanted) const;
    [[nodiscard]] std::vector<Correction> search(std::size_t limit, Unwanted& unwanted);
    [[nodiscard]] bool is_entailed_of_a_composite(const Conclusions& what, const Iri& iri) const;

    const Domain& domain_;
    Knowledge changed_;
    const std::vector<double>& costs_;
    std::vector<std::size_t> cheapest_first_;
    std::vector<ConfigurationSet> holds_;               ///< by answer: where it would be yes
    std::vector<std::vector<std::size_t>> answers_of_;  ///< by region
    Unwanted goal_, all_;                               ///< the concept itself; with every other incompatible one
    bool is_cut_short_ = false;
};

}  // namespace partonomy::knowledge
