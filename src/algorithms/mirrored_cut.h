#pragma once

#include "algorithms/object.h"

namespace partonomy {

/// Cuts the two sides of an object that is its own mirror image alike: where they were cut otherwise, both get the finer
/// of the two cuts, unless its pieces fit their boxes clearly less. Objects without an upright mirror plane, and places
/// that are no mirror image of another one, stay as they are. threads <= 0: all cores.
void cut_both_sides_alike(Object& object, int threads = 1);

}  // namespace partonomy
