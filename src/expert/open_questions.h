#pragma once

#include "expert/session.h"

namespace partonomy {

/// A part's name as it stands at the end.
struct Naming {
    std::vector<owl::Iri> concepts;  ///< that hold, entailed or assumed
    double certainty = 1;            ///< fraction of the configurations in which an assumed name holds
};

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
