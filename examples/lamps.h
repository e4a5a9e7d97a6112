#pragma once

#include <vector>

#include "examples/objects.h"

namespace partonomy {

/// The lamps of docs/guide.md: a floor lamp, a table lamp, a floor lamp on a foot too small for it, one without a
/// shade, and desk lamps with one and with two stems. `labels` and `object_class` are names of ontologies/lamps.omn.
[[nodiscard]] std::vector<ExampleObject> lamps();

}  // namespace partonomy
