#pragma once

#include <functional>
#include <string>
#include <vector>

#include "knowledge/lint.h"

// Inside of the check: what is wrong with relations between regions, and how findings list names.

namespace partonomy::knowledge {

/// Relations that no algorithm tells, names that wait for each other's, relations whose other side is never named.
/// `place_of`: where to look for a class.
[[nodiscard]] std::vector<Finding> lint_relations(const Domain& domain,
                                                  const std::function<owl::Source(const Iri&)>& place_of);

/// "Seat, Leg and Back"; of many the first `most` and how many more there are.
[[nodiscard]] std::string list_of(const std::vector<std::string>& names, std::size_t most = 8,
                                  const std::string& last = " and ");

[[nodiscard]] std::vector<std::string> local_names(const std::vector<Iri>& iris);

}  // namespace partonomy::knowledge
