#pragma once

#include <memory>

#include "expert/annotate.h"

namespace partonomy {

/// The session of the likeliest cut, after all questions; `cut` becomes that one. With Strategy::expert and
/// options.mend the cut is mended by what the ontology says of it; else it is asked about as it is.
[[nodiscard]] std::unique_ptr<Session> ask_about_likeliest(const knowledge::Domain& domain, const Catalogue& catalogue,
                                                           const Object& object, Cut& cut,
                                                           const AnnotateOptions& options);

}  // namespace partonomy
