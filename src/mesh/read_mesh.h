#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

class Companions;
struct SoupAppearance;

/// Polygons as a file holds them, before cleaning.
struct PolygonSoup {
    std::vector<Vec3> positions;
    std::vector<std::int32_t> corners;      ///< vertex indices of all faces, one face after the other
    std::vector<std::int64_t> face_starts;  ///< #F + 1 offsets into corners
    std::vector<std::string> notes;         ///< what the reader passed over and a user should know
    [[nodiscard]] std::int64_t face_count() const {
        return face_starts.empty() ? 0 : static_cast<std::int64_t>(face_starts.size()) - 1;
    }
};

enum class MeshFormat { off, obj, stl_ascii, stl_binary, ply, gltf };

/// The format told by the content, not by the name; nullopt when it is none of ours.
[[nodiscard]] std::optional<MeshFormat> detect_mesh_format(std::string_view bytes);

/// Parses the bytes of an OFF, OBJ, STL (ASCII, binary), PLY (ASCII, binary of both byte orders), glTF or GLB file.
/// `name` is what error sentences call the file. Throws MeshError: unknown format, truncated, number expected, NaN or
/// infinite coordinate, index out of range, no faces; the sentence names the line or the element.
[[nodiscard]] PolygonSoup parse_mesh(std::string_view bytes, const std::string& name);

/// The same for a file that may name others beside it (glTF its buffers). `appearance`: receives the colours, for which
/// material libraries and images are read, too; null leaves all of that unread.
[[nodiscard]] PolygonSoup parse_mesh(std::string_view bytes, const std::string& name, const Companions& companions,
                                     SoupAppearance* appearance);

/// What cleaning found and did; nothing is repaired silently.
struct MeshReport {
    std::int64_t input_vertices = 0;
    std::int64_t input_faces = 0;
    std::int64_t welded_vertices = 0;  ///< vertices merged into another one at the same place
    std::int64_t unused_vertices = 0;
    std::int64_t degenerate_faces = 0;   ///< input faces of zero area: they keep their number and carry no triangle
    std::int64_t duplicate_faces = 0;    ///< triangles that repeat another one's three corners, left out
    std::int64_t flipped_triangles = 0;  ///< turned to agree with their shell, or to face outward
    std::int64_t boundary_edges = 0;
    std::int64_t non_manifold_edges = 0;
    std::int64_t shells = 0;            ///< connected components of triangles
    std::int64_t cavities = 0;          ///< closed shells left facing inward, see clean_mesh
    std::int64_t one_sided_shells = 0;  ///< shells that no winding can make agree (Moebius strip)
    std::vector<std::string> notes;     ///< what the reader passed over
    [[nodiscard]] std::vector<std::string> sentences() const;  ///< what a user should know, nothing when all is well
};

struct LoadedMesh {
    TriangleMesh mesh;
    MeshReport report;
    std::string sha256;  ///< of the file's bytes
    /// glTF says itself what is up and how long a metre is: +y, and 1 unit.
    bool is_gltf = false;
};

struct CleanOptions {
    /// Vertices closer than this, relative to the bounding box diagonal, become one.
    double weld_tolerance = 1e-7;
};

/// Triangulates the polygons (any size, concave ones too), welds, drops what has no area, makes the winding of each
/// shell agree and face outward. A closed shell inside another one, wound consistently but opposite to it, is taken for
/// a cavity and stays so. A shell with openings is turned outward when it is nearly closed; a sheet keeps the side that
/// most of its triangles show. Indices of `soup` must be in range, as parse_mesh guarantees. `name` is for errors.
/// Throws MeshError when no triangle remains. O(#T log #T).
[[nodiscard]] TriangleMesh clean_mesh(const PolygonSoup& soup, const std::string& name, MeshReport& report,
                                      const CleanOptions& options = {});

/// read_file, parse_mesh and clean_mesh in one. Throws FileError, MeshError.
[[nodiscard]] LoadedMesh read_mesh(const std::filesystem::path& path, const CleanOptions& options = {});

}  // namespace partonomy
