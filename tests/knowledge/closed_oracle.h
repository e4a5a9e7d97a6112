#pragma once

#include "closed_answer.h"

/// The meaning of OWL 2 by enumeration: every interpretation of a tiny closed world, each axiom evaluated as the
/// specification states it. Worlds as closed_random makes them with `small_data`: data values are integers and others.
namespace closed_oracle {

[[nodiscard]] ClosedAnswer ask(const partonomy::knowledge::ClosedWorld& world);

}  // namespace closed_oracle
