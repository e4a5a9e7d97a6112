#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "knowledge/clauses.h"

namespace partonomy::knowledge {

/// A natural number of any size: how many configurations there are.
struct Count {
    std::string digits = "0";  ///< decimal
    double log2 = 0;           ///< -inf for 0
    [[nodiscard]] bool is_zero() const { return digits == "0"; }
};

/// The digits of a number that nobody has counted.
inline constexpr const char* too_many = "too many to count";

class SampledModels;

/// What a diagram may cost before it is given up.
struct DiagramOptions {
    std::size_t node_limit = 2'000'000;
    std::size_t memory_limit = std::size_t{1} << 30;  ///< bytes
    /// Of the search: clauses and variables looked at, in millions, about 60 s. A twentieth of it where rules tie so
    /// many variables together that success is unlikely.
    double step_limit = 3000;
    double seconds_limit = 0;  ///< 0: none. Whether it is reached hangs on the machine
};

/// A literal that counts for more or less than 1, say an answer that is likely but not sure.
struct LiteralWeight {
    int literal;
    double weight;  ///< >= 0; 0 is hard evidence against it; several for one literal multiply
};

/// The share of each literal in all models (or in their weights).
struct Shares {
    double log2_total = 0;     ///< of the number (the weight) of all models; -inf when there is none
    std::vector<double> each;  ///< [2 v] of variable v true, [2 v + 1] of it false; all 0 when there is no model

    [[nodiscard]] double of(int literal) const { return each[literal > 0 ? 2 * literal : 1 - 2 * literal]; }
    /// Exact: shares never round to 0 or up from it.
    [[nodiscard]] bool is_possible(int literal) const { return of(literal) > 0; }
    [[nodiscard]] bool is_inferred(int literal) const { return of(literal) > 0 && of(-literal) == 0; }
};

/// The exact number of models for each literal; same order as in Shares.
struct LiteralCounts {
    Count total;
    std::vector<Count> each;
    [[nodiscard]] const Count& of(int literal) const { return each[literal > 0 ? 2 * literal : 1 - 2 * literal]; }
};

/// All models of a formula, compiled once so that every question about their number takes one sweep. Immutable; copies
/// share the nodes.
///
/// A *sampled* one stands in where that would be too large: a solver tells exactly what is possible and inferred,
/// shares in between are estimates, and nothing is counted.
class Diagram {
public:
    /// Throws OntologyError when one of the limits is reached.
    explicit Diagram(const Clauses& clauses, const DiagramOptions& options = {});
    /// One that is sampled; `why` says why. Of the first `variables` of the formula, which the others help to say; 0:
    /// of all.
    [[nodiscard]] static Diagram sampled(const Clauses& clauses, std::string why, int variables = 0);
    /// Null unless it is sampled.
    [[nodiscard]] const SampledModels* sample() const { return sample_.get(); }

    [[nodiscard]] std::size_t node_count() const;     ///< decisions
    [[nodiscard]] std::size_t literal_count() const;  ///< in all nodes together: a sweep costs as much
    [[nodiscard]] int variable_count() const;
    [[nodiscard]] bool is_empty() const;  ///< the formula has no model

    /// Models in which every literal of `evidence` is true; too_many when sampled, unless there is none.
    [[nodiscard]] Count count(std::span<const int> evidence = {}) const;
    /// The same for each literal, in one sweep up and one down.
    [[nodiscard]] LiteralCounts count_each(std::span<const int> evidence = {}) const;
    /// The same as shares of the whole, in double precision; each literal may have a weight (when sampled, only 0
    /// counts).
    [[nodiscard]] Shares shares(std::span<const int> evidence = {}, std::span<const LiteralWeight> weights = {}) const;
    /// The same without weights, at once when it was asked before; safe for several threads. `evidence` ascends.
    [[nodiscard]] std::shared_ptr<const Shares> remembered_shares(const std::vector<int>& evidence) const;
    /// The first `limit` models (in an order of the diagram's own, always the same), each as its true variables,
    /// ascending. Costs no more than (models) x (variables). Not when sampled: std::logic_error.
    [[nodiscard]] std::vector<std::vector<int>> models(std::size_t limit, std::span<const int> evidence = {}) const;

    struct Nodes;

private:
    class Memory;
    Diagram();
    std::shared_ptr<const Nodes> nodes_;
    std::shared_ptr<Memory> memory_;
    std::shared_ptr<const SampledModels> sample_;
};

}  // namespace partonomy::knowledge
