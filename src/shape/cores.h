#pragma once

#include <cstdint>
#include <vector>

#include "shape/surface.h"

namespace partonomy {

/// What the space around a triangle's middle point (halfway to the opposite wall) looks like.
enum class Solidity : std::uint8_t { unknown, board, stick, cube };

/// Whether something may be but a fold that noise made at a crease: a small piece that is thinner than some triangles
/// are wide, or a larger one that is hardly thicker than one.
[[nodiscard]] inline bool is_fin(const Surface& s, double thickness, double area_share) {
    return (thickness < s.grain && area_share < 0.01) || (thickness < 0.6 * s.grain && area_share < 0.02);
}

/// The sure part of a part: triangles whose opposite wall belongs to it too.
struct Core {
    std::vector<std::int32_t> triangles;  ///< ascending
    Solidity kind = Solidity::unknown;
    double thickness = 0;        ///< median distance between its walls
    Vec3 normal = Vec3::Zero();  ///< across the walls (board)
    Vec3 axis = Vec3::Zero();    ///< along the stick
    double area = 0;
    bool is_exact = false;  ///< a board between two true planes: `middle`, `normal` and `half` tell which
    Vec3 middle = Vec3::Zero();
    double half = 0;
    double width = 0;          ///< across a board, in its plane
    std::int32_t family = -1;  ///< the same for boards that were parted because one is narrower than the other
    std::int32_t cut = -1;     ///< the same for pieces of one stick that a board crosses
};

/// Cores of all parts, those with the largest area first, and per triangle the number of its core or -1.
struct Cores {
    std::vector<Core> cores;
    std::vector<std::int32_t> core_of;
};

[[nodiscard]] Cores find_cores(const Surface& surface);

}  // namespace partonomy
