#pragma once

#include <set>

#include "owl/ontology.h"

namespace partonomy::knowledge {

/// The names of core's range concepts, values, relations and measured properties that no other file speaks of, not even
/// of a sibling of theirs: whoever names Red uses the whole range concept of hues. What touches (Connected) always
/// counts as used, since composite parts are made by it. Empty when core is not imported.
[[nodiscard]] std::set<owl::Iri> unused_features(const owl::Ontology& ontology);

}  // namespace partonomy::knowledge
