#pragma once

#include <memory>
#include <string>

#include "algorithms/relations.h"

namespace partonomy {

/// What core:criterion of a relation says: the name of a measure between regions, or a combination of such measures
/// and numbers, such as "rise - 2 * gap" (formula.h); as one measure, of that text. All must measure as many regions.
/// Fractions of the diagonal and of the height are not added to each other. Throws OntologyError with one sentence,
/// without a place.
[[nodiscard]] std::shared_ptr<const RelationMeasure> parse_relation_formula(const std::string& text);

}  // namespace partonomy
