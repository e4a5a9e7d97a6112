#pragma once

#include <utility>
#include <vector>

#include "knowledge/theory.h"

namespace partonomy::knowledge {

/// Of more concepts than this in an ontology, none is compared with the others, and what has a definition is believed to
/// be provable: both take the square of their number.
constexpr std::size_t most_compared = 3000;

/// How the concepts of one layer relate.
struct ConceptRelations {
    std::vector<std::vector<std::size_t>> alike;                                ///< groups of at least two
    std::vector<std::pair<std::size_t, std::vector<std::size_t>>> overlapping;  ///< with later ones
    std::vector<std::size_t> universal;
};

/// How these concepts of a space relate; `level` of a composite part is that of regions, of which nothing else is
/// compiled. Empty for more than `most_compared`.
[[nodiscard]] ConceptRelations relate(const Theory& theory, const Space& space, Level level,
                                      const std::vector<std::size_t>& concepts);

}  // namespace partonomy::knowledge
