#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/commands.h"
#include "expert/annotate.h"

namespace partonomy::app {

/// The file that is told, or annotation.json in the folder that is told.
[[nodiscard]] std::filesystem::path annotation_path(const std::string& told);

/// annotation.json of one annotated mesh, given as for annotation_path. Throws UsageError when it is none.
[[nodiscard]] nlohmann::json load_annotation(const std::string& told);

/// The ontology that the mesh was annotated with: `arguments.path`, or where it was then. Throws UsageError when it is
/// another one by now.
[[nodiscard]] knowledge::Domain load_same_ontology(OntologyArguments arguments, const nlohmann::json& annotation);

/// The answers that the annotation keeps, and what was known of the mesh.
[[nodiscard]] std::vector<LearnedAnswer> answers_of(const nlohmann::json& annotation);
[[nodiscard]] knowledge::Knowledge knowledge_of(const knowledge::Domain& domain, const nlohmann::json& annotation);

}  // namespace partonomy::app
