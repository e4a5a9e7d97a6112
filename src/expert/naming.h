#pragma once

#include <string>
#include <vector>

#include "expert/annotation.h"
#include "expert/session.h"

namespace partonomy {

/// A part's name as it stands at the end.
struct Naming {
    std::vector<owl::Iri> concepts;  ///< that hold, entailed or assumed
    double certainty = 1;            ///< fraction of the configurations in which an assumed name holds
};

/// The name of a region that lies in `possible`: all that is entailed of what the expert defined, else what holds in
/// most of the configurations. None of a contradiction, and of what nothing but helpers hold.
[[nodiscard]] Naming name_region(const Session& session, const knowledge::ConfigurationSet& possible);

/// The value of core:`name` at a concept; empty when it has none.
[[nodiscard]] std::string annotation_of(const knowledge::Domain& domain, const owl::Iri& iri, const char* name);

/// Whether a concept only serves to define others.
[[nodiscard]] bool is_helper(const knowledge::Domain& domain, const owl::Iri& iri);

[[nodiscard]] std::vector<std::string> local_names(const std::vector<owl::Iri>& iris);

/// Most specific first, the others after them.
[[nodiscard]] std::vector<owl::Iri> specific_first(const knowledge::Domain& domain, const std::vector<owl::Iri>& iris);

/// Local names of the most specific that are no diagnoses.
[[nodiscard]] std::vector<std::string> names_among(const knowledge::Domain& domain, const knowledge::Space& space,
                                                   std::vector<owl::Iri> iris);

/// The composite parts, those of which no concept is known left out; none is called by what is only `perhaps` so.
[[nodiscard]] std::vector<AnnotatedComposite> composite_parts(const Session& session,
                                                              const knowledge::Conclusions& known,
                                                              const std::vector<owl::Iri>& perhaps);

/// What a region of which only helpers hold is called by: the most specific concepts of the smallest composite part
/// that it belongs to; empty where it belongs to none.
[[nodiscard]] std::vector<owl::Iri> names_of_whole(const knowledge::Domain& domain, const knowledge::Conclusions& known,
                                                   int region);

/// Calls parts without a name of their own by the whole that they belong to.
void name_by_wholes(const knowledge::Domain& domain, const knowledge::Conclusions& known, Annotation& annotation);

/// Tells of each part without a name which one it came nearest to, and what refuses it.
void tell_nearest_names(const Session& session, const knowledge::Knowledge& knowledge, Annotation& annotation);

/// Whether the object is something that the ontology names and that is no diagnosis.
[[nodiscard]] bool is_recognised(const knowledge::Conclusions& known);

/// What an object comes nearest to, at most three classes, unless it is something that is no diagnosis.
[[nodiscard]] std::vector<NearClass> nearest_classes(const knowledge::Domain& domain,
                                                     const knowledge::Conclusions& assumed,
                                                     const std::vector<owl::Iri>& classes);

}  // namespace partonomy
