#pragma once

#include "expert/annotation.h"
#include "mesh/triangle_mesh.h"
#include "report/picture_rays.h"

namespace partonomy {

/// A rectangle of pixels.
struct Frame {
    int left = 0, top = 0, width = 0, height = 0;
};

/// A camera somewhat above the object, up being up, turned so that the parts are well seen, with the object filling the
/// frame. The same side of the object is chosen when it is turned about `up` (save where several sides are equally
/// good).
[[nodiscard]] Camera choose_view(const PictureRays& rays, const TriangleMesh& mesh, const Annotation& annotation,
                                 const Vec3& up, const Frame& frame);

}  // namespace partonomy
