#pragma once

#include <vector>

#include "expert/session.h"

namespace partonomy {

/// The axioms that define a class, or say something of it as a whole.
[[nodiscard]] std::vector<const owl::Axiom*> definitions_of(const knowledge::Domain& domain, const owl::Iri& iri);

/// Whether axioms name what a question is about: the property that is measured, a value of the range concept, or the
/// relation to other parts.
[[nodiscard]] bool is_named_in(const std::vector<const owl::Axiom*>& axioms, const knowledge::Variable& variable);

/// Asks of the parts to blame for what is incompatible all that its definition speaks of. Where a rule is broken in two
/// ways, the first that is known is enough to know that it is broken; what would mend it needs both.
void ask_what_rules_rest_on(Session& session);

}  // namespace partonomy
