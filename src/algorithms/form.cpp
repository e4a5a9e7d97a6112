/* Measures of a region's form: round, tapered, bent, hollow, convex; and its volume.
 *
 * A region is looked at along the axes of its smallest box: a stick along its length, a board along its length and
 * width, or through its thickness when its outline matters. Points evenly spread over the surface (samples.cpp) are
 * sorted into slices across the axis.
 *
 * - section spread: in each slice the points' distances from the slice's middle, scaled so that an ellipse becomes a
 *   circle, are averaged by direction; the value is the standard deviation of these means over their mean. Averages
 *   keep noise out, so of a coarse mesh, whose edges go where its noise is taken out, the points are on the mesh as it
 *   is; slices keep bends and tapers out. A circle has 0, a pentagon 0.06, a square 0.1, a triangle 0.2. Of a board it
 *   is the outline that counts, of a block the roundest of its axes.
 * - taper: root of the mean squared distance from the middle of the slice, near both ends: smaller over larger.
 * - bend: how far the middles of the slices leave their best straight line, over the length. Of a board across its
 *   thickness; in its plane, and of a block, only where both borders of the outline bow the same way, as those of an
 *   arch or a crescent do: any other outline that is no rectangle does not make it bent.
 * - wall: median over the points of the way through the material, against the normal, over the shortest length of the
 *   box. Points under which there is no opposite wall (sheets) count as 0.
 * - convexity: over many pairs of points, how far the second is behind the tangent plane of the first (convex) or
 *   before it (concave), the sum over the sum of absolute values. Flatter than a fiftieth counts as flat.
 * - volume: sum of tetrahedra over the triangles, with a fan over each opening, so that a leg that is open where it
 *   joins the seat has the volume of a closed one.
 *
 * The smallest box of a cone as wide as high stands askew. So a block whose surface is largely one cylinder, cone or
 * torus is sliced along the axis of that.
 *
 * All O(#T of the region) for the points, then a constant. */

#include "algorithms/form.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace partonomy {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double clearly_longer = 2;  // half way from "alike" to "obviously longer" (core:Shape)

bool is_stick(const Vec3& l) { return l[0] >= clearly_longer * l[1] && l[1] < clearly_longer * l[2]; }
bool is_board(const Vec3& l) { return l[1] >= clearly_longer * l[2]; }

/// Points of the region in the frame of its box, in slices of equal width along one axis between two shares of its
/// length.
struct Slices {
    std::vector<std::vector<Vec3>> slices;  ///< coordinates: along the axis, then along the two others
    std::vector<Vec3> facing;               ///< sum of the normals in each, in the same coordinates

    Slices(const SurfaceSamples& samples, const RegionMeasurements& region, int axis, int count, double from, double to,
           double steepest = 2) {
        slices.resize(static_cast<std::size_t>(count));
        facing.resize(static_cast<std::size_t>(count), Vec3::Zero());
        const std::array<int, 3> order{axis, axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
        for (std::size_t i = 0; i < samples.points.size(); ++i) {
            if (std::abs(samples.normals[i].dot(region.axes.col(axis))) > steepest) continue;
            const Vec3 place = region.axes.transpose() * (samples.with_edges()[i] - region.centre);
            const double share = region.lengths[axis] > 0 ? place[axis] / region.lengths[axis] + 0.5 : 0.5;
            const double at = (share - from) / (to - from) * count;
            if (at < 0 || at >= count) continue;
            slices[static_cast<std::size_t>(at)].emplace_back(place[order[0]], place[order[1]], place[order[2]]);
            const Vec3 normal = region.axes.transpose() * samples.normals[i];
            facing[static_cast<std::size_t>(at)] += Vec3(normal[order[0]], normal[order[1]], normal[order[2]]);
        }
    }
};

Vec3 mean_of(const std::vector<Vec3>& points) {
    return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) / static_cast<double>(points.size());
}

/// How far the points of each slice are from its middle, by direction and over the mean of the slice, in coordinates in
/// which an ellipse is a circle.
using ByDirection = std::array<std::vector<double>, 24>;

ByDirection distances_by_direction(const Slices& sliced) {
    constexpr std::size_t least_points = 12;
    ByDirection distances;
    for (const std::vector<Vec3>& slice : sliced.slices) {
        if (slice.size() < least_points) continue;
        const Vec3 middle = mean_of(slice);
        Vec3 variance = Vec3::Zero();
        for (const Vec3& p : slice) variance += (p - middle).cwiseAbs2();
        if (!(variance[1] > 0 && variance[2] > 0)) continue;
        const double squeeze = std::sqrt(variance[1] / variance[2]);
        std::vector<std::pair<std::size_t, double>> polar;
        double mean = 0;
        for (const Vec3& p : slice) {
            const double x = p[1] - middle[1], y = (p[2] - middle[2]) * squeeze;
            const double turn = std::atan2(y, x) / (2 * std::numbers::pi) + 0.5;
            const auto direction = static_cast<std::size_t>(turn * static_cast<double>(distances.size()));
            polar.emplace_back(std::min(distances.size() - 1, direction), std::hypot(x, y));
            mean += polar.back().second / static_cast<double>(slice.size());
        }
        for (const auto& [direction, distance] : polar) distances[direction].push_back(distance / mean);
    }
    return distances;
}

/// Standard deviation of the means by direction over their mean; nothing where half of the directions are empty.
double spread_of(const ByDirection& distances) {
    constexpr std::size_t least_points = 3;
    double filled = 0, mean = 0, squares = 0;
    for (const std::vector<double>& each : distances) {
        if (each.size() < least_points) continue;
        const double value = std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size());
        filled += 1;
        mean += value;
        squares += value * value;
    }
    if (filled < static_cast<double>(distances.size()) / 2) return nothing;
    mean /= filled;
    return std::sqrt(std::max(0.0, squares / filled - mean * mean)) / mean;
}

/// How far the sections across an axis are from ellipses; nothing without walls along it.
double spread_across(const Object& object, const RegionMeasurements& region, int axis) {
    constexpr double steepest = 0.7;   // beyond, a triangle is no wall along the axis
    constexpr double outermost = 0.1;  // of the points in one direction
    const SurfaceSamples& samples = samples_of(object, region);
    if (axis != 2 || !is_board(region.lengths))
        return spread_of(distances_by_direction(Slices(samples, region, axis, 6, 0.05, 0.95, steepest)));
    const double of_rim = spread_of(distances_by_direction(Slices(samples, region, axis, 1, -1, 2, steepest)));
    if (!std::isnan(of_rim)) return of_rim;
    // A rim as narrow as its triangles drowns in noise; then the outline is where the points end.
    ByDirection distances = distances_by_direction(Slices(samples, region, axis, 1, -1, 2));
    for (std::vector<double>& each : distances) {
        const auto kept = static_cast<std::ptrdiff_t>(std::ceil(outermost * static_cast<double>(each.size())));
        std::ranges::nth_element(each, each.begin() + std::min(kept, std::ssize(each)), std::greater<>());
        each.resize(static_cast<std::size_t>(kept));
    }
    return spread_of(distances);
}

/// Size of a cross-section.
double radius_of(const std::vector<Vec3>& slice) {
    if (slice.empty()) return 0;
    const Vec3 middle = mean_of(slice);
    double sum = 0;
    for (const Vec3& p : slice) sum += (p - middle).tail<2>().squaredNorm();
    return std::sqrt(sum / static_cast<double>(slice.size()));
}

/// How far the middles of slices leave a straight line in the coordinate `across` of Slices, over the axis' length.
double bend_along(const Object& object, const RegionMeasurements& region, int axis, int across) {
    // Where another part joins, one wall is missing, and what is left is not around the middle.
    constexpr double one_sided = 0.3;
    // The middles of a block's slices are less sure than those of a stick or a board, so they hold more points.
    const int slices = is_stick(region.lengths) || is_board(region.lengths) ? 10 : 4;
    const Slices sliced(samples_of(object, region), region, axis, slices, 0.03, 0.97);
    std::vector<Vec3> middles;
    for (const double most : {one_sided, 1.0}) {
        middles.clear();
        for (std::size_t i = 0; i < sliced.slices.size(); ++i) {
            const auto count = static_cast<double>(sliced.slices[i].size());
            if (count >= 5 && std::abs(sliced.facing[i][across]) <= most * count)
                middles.push_back(mean_of(sliced.slices[i]));
        }
        if (middles.size() >= 4) break;  // else it is a sheet: one-sided all over
    }
    if (middles.size() < 4 || !(region.lengths[axis] > 0)) return 0;
    const Vec3 mean = mean_of(middles);
    double xx = 0, xy = 0;
    for (const Vec3& m : middles) {
        xx += (m[0] - mean[0]) * (m[0] - mean[0]);
        xy += (m[0] - mean[0]) * (m[across] - mean[across]);
    }
    const double slope = xx > 0 ? xy / xx : 0;
    double low = 0, high = 0;
    for (const Vec3& m : middles) {
        const double off = m[across] - mean[across] - slope * (m[0] - mean[0]);
        low = std::min(low, off);
        high = std::max(high, off);
    }
    return (high - low) / region.lengths[axis];
}

/// How far both borders of the outline, seen along the third axis, bow to the same side, over the length along the
/// axis; 0 where one is straight, or bows to the other side. A border is the outermost of what faces outward, slice by
/// slice.
double bow_along(const Object& object, const RegionMeasurements& region, int axis, int across) {
    constexpr int slices = 12;
    constexpr double facing = 0.5, outermost = 0.15;   // of the points of a border in one slice
    constexpr double from = 1.0 / 6, share = 2.0 / 3;  // of the length: beyond, ends that are cut askew are no border
    const SurfaceSamples& samples = samples_of(object, region);
    std::array<std::array<std::vector<double>, slices>, 2> sides;  // by border and slice: how far out
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
        const double outward = samples.normals[i].dot(region.axes.col(across));
        if (std::abs(outward) < facing || !(region.lengths[axis] > 0)) continue;
        const Vec3 way = samples.points[i] - region.centre;
        const double at = (way.dot(region.axes.col(axis)) / region.lengths[axis] + 0.5 - from) / share * slices;
        if (at < 0 || at >= slices) continue;
        const double sign = outward > 0 ? 1 : -1;
        sides[outward > 0 ? 0 : 1][static_cast<std::size_t>(at)].push_back(sign * way.dot(region.axes.col(across)));
    }
    std::array<double, 2> bows{};
    for (std::size_t side = 0; side < 2; ++side) {
        // A parabola through the border's places: its curvature times a quarter is how far its middle leaves the chord.
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        Vec3 sums = Vec3::Zero();
        int met = 0;
        for (std::size_t k = 0; k < slices; ++k) {
            std::vector<double>& places = sides[side][k];
            if (places.size() < 3) continue;
            const auto kept =
                std::max<std::size_t>(1, static_cast<std::size_t>(outermost * static_cast<double>(places.size())));
            std::ranges::nth_element(places, places.begin() + static_cast<std::ptrdiff_t>(kept - 1), std::greater<>());
            const double place = (side == 0 ? 1 : -1) * places[kept - 1];
            const double x = from + (static_cast<double>(k) + 0.5) / slices * share - 0.5;
            const Vec3 row(1, x, x * x);
            squares += row * row.transpose();
            sums += place * row;
            ++met;
        }
        if (met < slices / 2) return 0;
        bows[side] = squares.ldlt().solve(sums)[2] / 4;
    }
    if (bows[0] * bows[1] <= 0) return 0;
    return std::min(std::abs(bows[0]), std::abs(bows[1])) / region.lengths[axis];
}

/// A block that is round about an axis, in a frame along that axis: its smallest box may stand askew, and its sides are
/// all alike. Nothing for anything else.
std::optional<RegionMeasurements> about_its_axis(const Object& object, const RegionMeasurements& region) {
    constexpr double most_of_it = 0.3;  // the wall of a cone on a base that is as large
    if (is_stick(region.lengths) || is_board(region.lengths)) return std::nullopt;
    const Patch* wall = nullptr;
    double area = 0;
    for (const Patch& patch : patches_of(object, region)) {
        area += patch.area;
        const SurfaceKind kind = patch.primitive.kind;
        if (kind != SurfaceKind::cylinder && kind != SurfaceKind::cone && kind != SurfaceKind::torus) continue;
        if (!wall || patch.area > wall->area) wall = &patch;
    }
    if (!wall || wall->area < most_of_it * area) return std::nullopt;
    const SurfaceSamples& samples = samples_of(object, region);
    if (samples.points.empty()) return std::nullopt;
    RegionMeasurements turned = region;
    const Vec3 axis = wall->primitive.axis, side = axis.unitOrthogonal();
    turned.axes << axis, side, axis.cross(side);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec3& p : samples.points) {
        low = low.cwiseMin(turned.axes.transpose() * p);
        high = high.cwiseMax(turned.axes.transpose() * p);
    }
    turned.lengths = high - low;
    turned.centre = turned.axes * (low + high) / 2;
    return turned;
}

}  // namespace

double section_spread(const Object& object, const RegionMeasurements& region) {
    if (is_board(region.lengths)) return spread_across(object, region, 2);
    if (is_stick(region.lengths)) return spread_across(object, region, 0);
    if (const auto turned = about_its_axis(object, region)) return spread_across(object, *turned, 0);
    double least = nothing;
    for (int axis = 0; axis < 3; ++axis) least = std::fmin(least, spread_across(object, region, axis));
    return least;
}

double end_ratio(const Object& object, const RegionMeasurements& region) {
    const auto turned = about_its_axis(object, region);
    const int axes = is_stick(region.lengths) || turned ? 1 : is_board(region.lengths) ? 2 : 3;
    double least = nothing;
    for (int axis = 0; axis < axes; ++axis) {
        const Slices sliced(samples_of(object, region), turned.value_or(region), axis, 4, 0.1, 0.9);
        const double first = radius_of(sliced.slices.front()), last = radius_of(sliced.slices.back());
        if (first > 0 && last > 0) least = std::fmin(least, std::min(first, last) / std::max(first, last));
    }
    return least;
}

double bend(const Object& object, const RegionMeasurements& region) {
    if (is_stick(region.lengths)) return std::max(bend_along(object, region, 0, 1), bend_along(object, region, 0, 2));
    double most = 0;
    if (const auto turned = about_its_axis(object, region))
        most = std::max(bend_along(object, *turned, 0, 1), bend_along(object, *turned, 0, 2));
    else
        most = std::max(bend_along(object, region, 0, 2), bend_along(object, region, 1, 2));
    for (int axis = 0; axis < 3; ++axis)
        for (int across = 0; across < 3; ++across) {
            const bool is_in_plane = axis != 2 && across != 2;
            if (axis != across && (is_in_plane || !is_board(region.lengths)))
                most = std::max(most, bow_along(object, region, axis, across));
        }
    return most;
}

double wall_thickness(const Object& object, const RegionMeasurements& region) {
    const SurfaceSamples& samples = samples_of(object, region);
    if (samples.points.empty() || !object.tree || !(region.lengths[2] > 0)) return nothing;
    const double lift = 1e-4 * region.lengths.norm();
    std::vector<double> ways;
    for (std::size_t i = 0; i < samples.points.size(); i += 10) {
        const Vec3 inward = -samples.normals[i];
        ways.push_back(object.tree->first_hit(samples.origins[i] + lift * inward, inward).value_or(0));
    }
    const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
    std::nth_element(ways.begin(), middle, ways.end());
    return *middle / region.lengths[2];
}

double convexity(const Object& object, const RegionMeasurements& region) {
    constexpr double flat = 0.02;
    constexpr std::size_t partners = 16;
    const SurfaceSamples& samples = samples_of(object, region);
    const std::size_t count = samples.points.size();
    if (count < 2) return nothing;
    double sum = 0, absolute = 0, distance = 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 1; k <= partners; ++k) {
            const Vec3 way = samples.points[(i + k * count / (partners + 1)) % count] - samples.points[i];
            const double behind = -samples.normals[i].dot(way);
            sum += behind;
            absolute += std::abs(behind);
            distance += way.norm();
        }
    return sum / (absolute + flat * distance);
}

double enclosed_volume(const Object& object, const RegionMeasurements& region) {
    if (region.triangles.empty()) return nothing;
    const TriangleMesh& mesh = object.mesh;
    const auto at = [&](std::int32_t v) -> const Vec3& { return mesh.positions[static_cast<std::size_t>(v)]; };
    const Vec3 origin = at(mesh.triangles[static_cast<std::size_t>(region.triangles.front())][0]);
    double sixfold = 0;
    std::vector<std::array<std::int32_t, 2>> edges;
    for (const std::int32_t t : region.triangles) {
        const auto& c = mesh.triangles[static_cast<std::size_t>(t)];
        sixfold += (at(c[0]) - origin).dot((at(c[1]) - origin).cross(at(c[2]) - origin));
        for (std::size_t e = 0; e < 3; ++e) edges.push_back({c[e], c[(e + 1) % 3]});
    }
    // Edges that no other triangle of the region runs back along are the rims of its openings.
    std::ranges::sort(edges);
    std::vector<std::array<std::int32_t, 2>> rims;
    for (const auto& [a, b] : edges)
        if (!std::ranges::binary_search(edges, std::array{b, a})) rims.push_back({a, b});
    std::map<std::int32_t, std::int32_t> parent;
    const auto root = [&](std::int32_t v) {
        while (parent.at(v) != v) v = parent[v] = parent.at(parent.at(v));
        return v;
    };
    for (const auto& rim : rims)
        for (const std::int32_t v : rim) parent.emplace(v, v);
    for (const auto& [a, b] : rims) parent[root(a)] = root(b);
    std::map<std::int32_t, std::pair<Vec3, int>> middles;
    for (const auto& rim : rims) {
        auto& [sum, count] = middles.try_emplace(root(rim[0]), Vec3::Zero(), 0).first->second;
        sum += at(rim[0]) - origin;
        ++count;
    }
    for (const auto& [a, b] : rims) {
        const auto& [sum, count] = middles.at(root(a));
        sixfold += (sum / count).dot((at(b) - origin).cross(at(a) - origin));
    }
    return std::abs(sixfold) / 6;
}

}  // namespace partonomy
