#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "knowledge/diagram.h"

namespace partonomy::knowledge {

/// A fixed number of models, as a column of bits for each variable.
struct ModelSample {
    std::size_t size = 0;
    std::vector<std::vector<std::uint64_t>> columns;  ///< [variable]; 0 is not used
    /// Models in which both literals are true.
    [[nodiscard]] std::size_t count(int literal, int other) const;
    [[nodiscard]] std::size_t count(int literal) const { return count(literal, literal); }
};

/// What a SAT solver knows of a formula whose diagram would be too large. Safe for several threads; the same formula
/// and evidence give the same answers, whatever was asked before.
class SampledModels {
public:
    /// Of the first `variables` of the formula; the others only help to say it.
    SampledModels(const Clauses& clauses, std::string why, int variables);
    ~SampledModels();

    [[nodiscard]] int variable_count() const;
    [[nodiscard]] std::size_t clause_count() const;
    [[nodiscard]] const std::string& why() const;
    [[nodiscard]] bool has_model(std::span<const int> evidence) const;
    /// Possible and inferred exactly; in between, the share of a sample.
    [[nodiscard]] Shares shares(std::span<const int> evidence) const;
    /// Some hundred models in which the evidence is true; none when there is none.
    [[nodiscard]] ModelSample sample(std::span<const int> evidence) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace partonomy::knowledge
