#pragma once

#include <string>
#include <vector>

#include "expert/annotation.h"
#include "expert/session.h"

namespace partonomy {

/// Teaches a session what a person says of its regions (Session::correct), one answer after the other. Answers are
/// named as in Annotation::answers; a local name ("Shape") will do for an IRI, and `score` plays no role. `source`: the
/// file that they come from, for error sentences. Throws UsageError, and changes nothing, when there is no such part,
/// feature or value (with the nearest right spelling), or when the answers about one part cannot all hold.
void accept_answers(Session& session, const std::vector<LearnedAnswer>& answers, const std::string& source);

}  // namespace partonomy
