#pragma once

#include <set>
#include <string>

namespace partonomy::owl {

/// The text of the built-in core ontology without the features that `names` do not speak of: their lines are empty, so
/// that every other line keeps its number. `names` are IRIs of core's terms. What is left is a module of core: it says
/// the same of these names as the whole.
[[nodiscard]] std::string core_module(const std::set<std::string>& names);

}  // namespace partonomy::owl
