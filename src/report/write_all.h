#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "expert/annotation.h"
#include "mesh/triangle_mesh.h"
#include "report/write.h"

namespace partonomy {

/// The formats of write_outputs, sorted: glb, json, labels, ply, png, trace.
[[nodiscard]] std::vector<std::string> output_formats();

/// Throws UsageError that lists the known formats when one of `formats` is none of them.
void check_formats(const std::set<std::string>& formats);

/// Writes the chosen formats into a folder, which is made when it does not exist (its parents too): labels.txt,
/// annotation.json, annotation.ply, annotation.glb, preview.png, trace.txt. All or nothing: until every file is
/// complete, an existing folder keeps its old files and a new one does not appear. Files of other names are left alone.
/// `up` is the mesh's up direction. Throws UsageError (unknown format, annotation of another mesh), FileError.
void write_outputs(const std::filesystem::path& folder, const std::set<std::string>& formats, const TriangleMesh& mesh,
                   const Annotation& annotation, const Vec3& up, const PreviewOptions& preview);

}  // namespace partonomy
