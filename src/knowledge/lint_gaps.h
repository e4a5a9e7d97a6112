#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "knowledge/domain.h"

namespace partonomy::knowledge {

/// "between 6 and 12.5 of l0/l2 neither Slender nor Stocky fits": the first measurement that no value of a covered
/// range accepts although smaller and larger ones are accepted. Empty where there is none, and where a value is
/// measured otherwise than by one trapezoid over the measure of the others.
[[nodiscard]] std::string gap_between_values(const RangeConcept& range);

/// Two values of a range, and where both have a score of 1: "up to 35 of length inclination".
struct ValuesThatBothFit {
    std::size_t one, other;
    std::string where;
};

/// Values exclude each other, so no measurement should fit two of them fully. Only values that are measured by the same
/// measures are compared; ones that meet in a single number may.
[[nodiscard]] std::vector<ValuesThatBothFit> values_that_both_fit(const RangeConcept& range);

}  // namespace partonomy::knowledge
