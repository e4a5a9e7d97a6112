#pragma once

#include <vector>

#include "knowledge/explanations.h"
#include "knowledge/theory.h"

namespace partonomy::knowledge {

/// Axioms (indices into Ontology::axioms, ascending) that together leave nothing; without any of them something would
/// be left.
using Cause = std::vector<std::size_t>;

/// Why nothing can be a member of `id`, a concept of the theory; the smallest first. None when something can, or when
/// the theory is more than ObjectClauses can express. One
/// minimal cause when the concept rests on very many axioms, else up to `limit`.
[[nodiscard]] std::vector<Cause> causes_of_unsatisfiable(const Theory& theory, int id, std::size_t limit = 3);

/// The same for a whole layer: why there can be no region, or no object, at all.
[[nodiscard]] std::vector<Cause> causes_of_nothing(const Theory& theory, Level level, std::size_t limit = 3);

}  // namespace partonomy::knowledge
