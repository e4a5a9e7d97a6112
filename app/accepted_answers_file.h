#pragma once

#include <string>
#include <vector>

#include "expert/annotation.h"

namespace partonomy::app {

/// What a person says of the parts of one mesh: a JSON list of answers as annotation.json has them,
/// [{"part": 3, "feature": "Shape", "value": "Stick", "yes": true}]. "yes" may be left out; "score" and "accepted" may
/// be there. Throws FileError, and UsageError with file and line for what is no such list.
[[nodiscard]] std::vector<LearnedAnswer> load_accepted_answers(const std::string& path);

}  // namespace partonomy::app
