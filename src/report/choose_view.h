#pragma once

#include "expert/annotation.h"
#include "report/camera.h"

namespace partonomy {

/// A camera somewhat above the object, up being up, turned so that the parts are well seen, with the object filling the
/// frame. The same side of the object is chosen when it is turned about `up` (save where several sides are equally
/// good).
[[nodiscard]] Camera choose_view(const PlacedMesh& mesh, const Annotation& annotation, const Vec3& up,
                                 const Frame& frame, int threads = 1);

}  // namespace partonomy
