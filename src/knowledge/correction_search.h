#pragma once

#include "knowledge/explain.h"

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
        std::vector<ConfigurationSet> regions;  ///< by region
        ConfigurationSet objects;
        std::vector<Iri> concepts = {};  ///< that no composite part must be
    };
    [[nodiscard]] bool mends(const std::vector<std::size_t>& set, const Unwanted& unwanted);
    [[nodiscard]] std::vector<Correction> search(std::size_t limit, const Unwanted& unwanted);

    const Domain& domain_;
    Knowledge changed_;
    const std::vector<double>& costs_;
    std::vector<std::size_t> cheapest_first_;
    [[nodiscard]] bool is_entailed_of_a_composite(const Conclusions& what, const Iri& iri) const;

    Unwanted goal_, all_;  ///< the concept itself; with every other incompatible one
    bool is_cut_short_ = false;
};

}  // namespace partonomy::knowledge
