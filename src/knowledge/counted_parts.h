#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "owl/ontology.h"

namespace partonomy::knowledge {

/// How many parts of one name a definition asks for: "hasPart max 0 Fin" and "not (hasPart some Fin)" at most none.
struct CountedPart {
    owl::Iri iri;
    std::optional<std::uint32_t> at_least, at_most;  ///< one of them, or both: "exactly 2"
};

struct CountedParts {
    std::vector<CountedPart> parts;  ///< in the order in which the definition names them
    bool is_all = true;  ///< the definition says nothing else of parts: no other class expression, no alternatives
};

/// What the definition of a class (its first EquivalentTo) demands of numbers of parts of a name: where these are so,
/// and the class is whatever else the definition asks for, it holds.
[[nodiscard]] CountedParts counted_parts(const owl::Ontology& ontology, const owl::Iri& iri);

}  // namespace partonomy::knowledge
