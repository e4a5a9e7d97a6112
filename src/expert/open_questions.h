#pragma once

#include "expert/naming.h"

namespace partonomy {

/// What follows when the assumed names of all parts, or of some, count as known.
[[nodiscard]] knowledge::Conclusions conclude_assuming(const knowledge::Domain& domain,
                                                       const knowledge::Knowledge& knowledge,
                                                       const knowledge::Conclusions& known,
                                                       const std::vector<Naming>& namings,
                                                       const std::vector<int>* regions = nullptr);

/// What is still open, and why, in sentences: names that are assumed, what is perhaps incompatible, composite parts
/// that there may be, parts and surface without a name.
[[nodiscard]] std::vector<std::string> open_questions(const Session& session, const knowledge::Knowledge& knowledge,
                                                      const std::vector<Naming>& namings,
                                                      const knowledge::Conclusions& known,
                                                      const knowledge::Conclusions& assumed,
                                                      const std::vector<owl::Iri>& perhaps);

}  // namespace partonomy
