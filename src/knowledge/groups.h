#pragma once

#include <span>

#include "knowledge/ground.h"

namespace partonomy::knowledge {

/// A composite concept, and the classes of parts that its definition speaks of, as written: (formula, level).
struct Mentions {
    int concept_id;
    std::vector<std::pair<FormulaId, Level>> parts;
};

/// Fills Theory::groups, and NamedConcept::group of the composite concepts that say what they consist of. `told`:
/// concepts that are told to be below others. Throws OntologyError when groups are made of each other, or when what
/// belongs to them can never be known.
void find_groups(Theory& theory, Grounder& grounder, std::span<const Mentions> mentions,
                 std::span<const std::pair<int, int>> told, const owl::Ontology& ontology);

}  // namespace partonomy::knowledge
