#pragma once

#include "expert/annotation.h"
#include "mesh/triangle_mesh.h"
#include "report/canvas.h"
#include "report/choose_view.h"
#include "report/write.h"

namespace partonomy {

/// Draws the object into the frame of the canvas: parts in their colours, shaded, with dark lines where one part ends
/// or hides another; seen from where the parts of `viewed` are seen best. Same pixels for any number of threads.
void draw_object(Canvas& canvas, const Frame& frame, const TriangleMesh& mesh, const Annotation& annotation,
                 const Annotation& viewed, const Vec3& up, const PreviewOptions& options);

}  // namespace partonomy
