#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/commands.h"
#include "expert/annotate.h"

namespace partonomy::app {

/// annotation.json of one annotated mesh. Throws UsageError when it is none.
[[nodiscard]] nlohmann::json load_annotation(const std::string& folder);

/// The ontology that the mesh was annotated with: `arguments.path`, or where it was then. Throws UsageError when it is
/// another one by now.
[[nodiscard]] knowledge::Domain load_same_ontology(OntologyArguments arguments, const nlohmann::json& annotation);

/// The answers that the annotation keeps, and what was known of the mesh.
[[nodiscard]] std::vector<LearnedAnswer> answers_of(const nlohmann::json& annotation);
[[nodiscard]] knowledge::Knowledge knowledge_of(const knowledge::Domain& domain, const nlohmann::json& annotation);

}  // namespace partonomy::app
