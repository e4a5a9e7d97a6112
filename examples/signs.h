#pragma once

#include <vector>

#include "examples/paint.h"

namespace partonomy {

/// Traffic signs on a pole, for ontologies/traffic-signs.omn: the fields of a sign lie flush in one plane, and most
/// signs have the same shape, so only their colours tell them apart. Labels and object_class are those that must be
/// found.
[[nodiscard]] std::vector<PaintedObject> signs();

/// The same shapes in colours that no sign has, or on a pole that is no pole's colour; `incompatibility` names what is
/// wrong, or the object class is empty: not recognised.
[[nodiscard]] std::vector<PaintedObject> wrong_signs();

}  // namespace partonomy
