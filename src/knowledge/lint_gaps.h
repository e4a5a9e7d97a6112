#pragma once

#include "knowledge/domain.h"

namespace partonomy::knowledge {

/// "between 6 and 12.5 of l0/l2 neither Slender nor Stocky fits": the first measurement that no value of a covered
/// range accepts although smaller and larger ones are accepted. Empty where there is none, and where a value is
/// measured otherwise than by one trapezoid over the measure of the others.
[[nodiscard]] std::string gap_between_values(const RangeConcept& range);

}  // namespace partonomy::knowledge
