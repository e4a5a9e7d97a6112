/* Both sides of a thing that is its own mirror image, cut alike.
 *
 * Where a bent stick may be one piece or two, a hair decides; and the triangles on the left are hardly ever the mirror
 * image of those on the right. So each side is cut well, and yet they differ, which no namer can mend: the left temple
 * of a pair of spectacles would be longer than the right one. So the cut is compared with its own mirror image. Pieces
 * of one side and of the other that lie in each other's place make a group; where they are not one for one, both sides
 * take the cut of one of them: the finer one, since what is apart can be joined by knowledge, unless its pieces fill
 * their boxes less well.
 *
 * The mirror image of a triangle is what a ray meets that comes from within the solid where its image should be: large
 * triangles of another tiling do no harm. Cost: O(n) for the plane and at most 20,000 rays; where the sides differ, one
 * ray for each triangle of a group and the boxes of its pieces. */

#include "algorithms/mirrored_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "algorithms/mirror_plane.h"
#include "base/ranges.h"
#include "mesh/parallel.h"
#include "shape/part_box.h"
#include "shape/pieces.h"
#include "shape/ray_scene.h"

namespace partonomy {
namespace {

constexpr std::size_t enough = 20000;   // triangles that are looked at
constexpr double near = 0.01;           // of the object's size: so far may an image be from the surface
constexpr double alike_cosine = 0.7;    // of normals
constexpr double least_overlap = 0.1;   // of the smaller piece: so much in the same place is no frayed border
constexpr double least_mirrored = 0.9;  // of the pieces of a group
constexpr double least_unlike = 0.08;   // of a side that lies in the place of another piece
constexpr double clearly_less = 0.03;   // mean fit
constexpr double least_piece = 0.05;    // of a part: less is fraying

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Every step-th triangle.
Object thin_out(const Object& object, std::size_t step) {
    Object thin;
    thin.placement = object.placement;
    for (std::size_t t = 0; t < object.mesh.triangles.size(); t += step) {
        std::array<std::int32_t, 3> corners{};
        for (std::size_t e = 0; e < 3; ++e) {
            corners[e] = static_cast<std::int32_t>(thin.mesh.positions.size());
            thin.mesh.positions.push_back(object.mesh.positions[at(object.mesh.triangles[t][e])]);
        }
        thin.mesh.triangles.push_back(corners);
    }
    thin.geometry = compute_geometry(thin.mesh);
    return thin;
}

class MirrorImage {
public:
    MirrorImage(const Object& object, const Vec3& side, int threads)
        : object_(object), side_(side), scene_(object.mesh, object.tree, nullptr, threads) {
        double area = 0;
        for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
            area += object.geometry.areas[t];
            middle_ += object.geometry.areas[t] * object.geometry.barycentres[t];
        }
        middle_ /= area;
        reach_ = near * compute_bounds(object.mesh, threads).diagonal();
    }

    /// The triangle in the place of the mirror image of another one, or -1.
    [[nodiscard]] std::int32_t of(std::int32_t t) const {
        const Vec3 &place = object_.geometry.barycentres[at(t)], &normal = object_.geometry.normals[at(t)];
        const Vec3 image = place - 2 * (place - middle_).dot(side_) * side_;
        const Vec3 outward = normal - 2 * normal.dot(side_) * side_;
        for (const double share : {0.1, 0.3, 1.0}) {  // walls may lie close to one another
            const double reach = share * reach_;
            const WallHit hit = scene_.exit_wall({image - reach * outward, outward});
            if (hit.triangle >= 0 && hit.distance < 2 * reach &&
                object_.geometry.normals[at(hit.triangle)].dot(outward) > alike_cosine)
                return hit.triangle;
        }
        return -1;
    }

private:
    const Object& object_;
    Vec3 side_, middle_ = Vec3::Zero();
    double reach_ = 0;
    RayScene scene_;
};

/// How much of each part lies in the place of the mirror image of each other one.
struct Overlaps {
    std::vector<double> area;  ///< of the parts
    std::map<std::pair<std::int32_t, std::int32_t>, double> common;
};

Overlaps find_overlaps(const Object& object, const MirrorImage& image, const std::vector<std::int32_t>& part_of,
                       std::size_t step, int threads) {
    const std::size_t count = (part_of.size() + step - 1) / step;
    std::vector<std::int32_t> images(count);
    for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) images[k] = image.of(static_cast<std::int32_t>(k * step));
    });
    Overlaps overlaps{std::vector<double>(object.candidates.size(), 0.0), {}};
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t own = part_of[k * step];
        if (own < 0) continue;
        const double area = object.geometry.areas[k * step];
        overlaps.area[at(own)] += area;
        if (images[k] >= 0 && part_of[at(images[k])] >= 0) overlaps.common[{own, part_of[at(images[k])]}] += area;
    }
    return overlaps;
}

/// Pieces of one side, and those of the other in their place.
struct Group {
    std::set<std::int32_t> here, there;
};

std::vector<Group> find_groups(const Overlaps& overlaps) {
    const auto parts = static_cast<std::int32_t>(overlaps.area.size());
    Sets sets(2 * overlaps.area.size());  // parts as they are, then as images
    for (const auto& [pair, area] : overlaps.common)
        if (area > least_overlap * std::min(overlaps.area[at(pair.first)], overlaps.area[at(pair.second)]))
            sets.join(pair.first, parts + pair.second);
    std::map<std::int32_t, Group> groups;
    for (std::int32_t p = 0; p < parts; ++p) {
        groups[sets.find(p)].here.insert(p);
        groups[sets.find(parts + p)].there.insert(p);
    }
    std::vector<Group> all;
    for (auto& [root, group] : groups) all.push_back(std::move(group));
    return all;
}

/// How much of some parts lies in the place of others, and how much of it in that which most of each part lies in.
struct Match {
    double mirrored = 0, one_for_one = 0;
};

Match match(const Overlaps& overlaps, const std::set<std::int32_t>& from, const std::set<std::int32_t>& to) {
    Match result;
    double area = 0;
    for (const std::int32_t p : from) {
        double most = 0;
        for (const std::int32_t q : to) {
            const auto found = overlaps.common.find({p, q});
            if (found == overlaps.common.end()) continue;
            result.mirrored += found->second;
            most = std::max(most, found->second);
        }
        result.one_for_one += most;
        area += overlaps.area[at(p)];
    }
    return {result.mirrored / area, result.one_for_one / area};
}

/// Whether the sides are each other's image, and yet cut otherwise.
bool differ(const Overlaps& overlaps, const Group& group) {
    if (group.here.empty() || group.there.empty() || group.here.size() + group.there.size() == 2) return false;
    if (std::ranges::any_of(group.here, [&](std::int32_t p) { return group.there.contains(p); })) return false;
    const Match here = match(overlaps, group.here, group.there), there = match(overlaps, group.there, group.here);
    return std::min(here.mirrored, there.mirrored) > least_mirrored &&
           std::min(here.one_for_one, there.one_for_one) < 1 - least_unlike;
}

double mean_fit(const Object& object, const Overlaps& overlaps, const std::set<std::int32_t>& parts) {
    double fit = 0, area = 0;
    for (const std::int32_t p : parts) {
        fit += overlaps.area[at(p)] * object.candidates[at(p)].fit;
        area += overlaps.area[at(p)];
    }
    return fit / area;
}

/// Gives each triangle of some parts the number of the part that its image is in, of those that are to be followed; -1
/// elsewhere. What frays goes to its neighbours.
std::vector<std::int32_t> follow(const Object& object, const MirrorImage& image,
                                 const std::vector<std::int32_t>& part_of, const std::set<std::int32_t>& parts,
                                 const std::set<std::int32_t>& followed, const Adjacency& adjacency, int threads) {
    std::vector<std::int32_t> mine;
    for (const std::int32_t p : parts)
        mine.insert(mine.end(), object.candidates[at(p)].region.triangles.begin(),
                    object.candidates[at(p)].region.triangles.end());
    std::ranges::sort(mine);
    std::vector<std::int32_t> wanted(part_of.size(), -1);
    constexpr std::int32_t open = -2;
    for_each_range(mine.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::int32_t there = image.of(mine[k]);
            const bool is_followed = there >= 0 && followed.contains(part_of[at(there)]);
            wanted[at(mine[k])] = is_followed ? part_of[at(there)] : open;
        }
    });
    std::map<std::int32_t, double> areas;
    for (const std::int32_t t : mine)
        if (wanted[at(t)] >= 0) areas[wanted[at(t)]] += object.geometry.areas[at(t)];
    const Pieces pieces = find_pieces(adjacency, threads, [&](std::int32_t i, std::int32_t j) {
        return wanted[at(i)] >= 0 && wanted[at(i)] == wanted[at(j)];
    });
    std::vector<double> piece_areas(pieces.size(), 0.0);
    for (const std::int32_t t : mine)
        if (pieces.piece_of[at(t)] >= 0) piece_areas[at(pieces.piece_of[at(t)])] += object.geometry.areas[at(t)];
    if (areas.empty()) return std::vector<std::int32_t>(part_of.size(), -1);
    std::vector<std::int32_t> queue;
    for (const std::int32_t t : mine)
        if (wanted[at(t)] >= 0) {
            if (piece_areas[at(pieces.piece_of[at(t)])] < least_piece * areas[wanted[at(t)]])
                wanted[at(t)] = open;
            else
                queue.push_back(t);
        }
    for (std::size_t k = 0; k < queue.size(); ++k)
        for (const std::int32_t n : adjacency.neighbours[at(queue[k])])
            if (n >= 0 && wanted[at(n)] == open) {
                wanted[at(n)] = wanted[at(queue[k])];
                queue.push_back(n);
            }
    const auto largest = std::ranges::max_element(areas, {}, [](const auto& entry) { return entry.second; });
    for (const std::int32_t t : mine)
        if (wanted[at(t)] == open) wanted[at(t)] = largest->first;  // a shell without an image
    return wanted;
}

}  // namespace

void cut_both_sides_alike(Object& object, int threads) {
    if (object.candidates.size() < 3) return;
    const std::size_t step = 1 + object.mesh.triangles.size() / enough;
    const std::optional<Vec3> side = step == 1 ? mirror_side(object) : mirror_side(thin_out(object, step));
    if (!side) return;
    std::vector<std::int32_t> part_of(object.mesh.triangles.size(), -1);
    for (std::size_t p = 0; p < object.candidates.size(); ++p)
        for (const std::int32_t t : object.candidates[p].region.triangles)
            part_of[at(t)] = static_cast<std::int32_t>(p);
    const MirrorImage image(object, *side, threads);
    const Overlaps overlaps = find_overlaps(object, image, part_of, step, threads);
    std::set<std::int32_t> settled, replaced;
    std::vector<PartRegion> pieces;
    std::optional<Adjacency> adjacency;
    for (const Group& group : find_groups(overlaps)) {
        const auto is_settled = [&](std::int32_t part) { return settled.contains(part); };
        if (!differ(overlaps, group) || std::ranges::any_of(group.here, is_settled) ||
            std::ranges::any_of(group.there, is_settled))
            continue;
        settled.insert(group.here.begin(), group.here.end());
        settled.insert(group.there.begin(), group.there.end());
        double gain = mean_fit(object, overlaps, group.here) - mean_fit(object, overlaps, group.there);
        if (group.here.size() != group.there.size())
            gain += group.here.size() > group.there.size() ? clearly_less : -clearly_less;
        const auto& [followed, following] =
            gain > 0 ? std::pair(group.here, group.there) : std::pair(group.there, group.here);
        if (!adjacency) adjacency = build_adjacency(object.mesh, threads);
        const std::vector<std::int32_t> wanted =
            follow(object, image, part_of, following, followed, *adjacency, threads);
        std::map<std::int32_t, std::vector<std::int32_t>> triangles;
        for (std::size_t t = 0; t < wanted.size(); ++t)
            if (wanted[t] >= 0) triangles[wanted[t]].push_back(static_cast<std::int32_t>(t));
        for (auto& [part, own] : triangles) {
            PartBox box = measure_part(object.mesh, object.geometry, own, object.is_noisy, threads);
            pieces.push_back({{std::move(own), std::move(box.memberships)}, box.box, box.fit, object.is_noisy});
        }
        replaced.insert(following.begin(), following.end());
    }
    if (replaced.empty()) return;
    for (std::size_t p = 0; p < object.candidates.size(); ++p)
        if (!replaced.contains(static_cast<std::int32_t>(p))) pieces.push_back(std::move(object.candidates[p]));
    std::ranges::sort(pieces, {}, [](const PartRegion& part) { return part.region.triangles.front(); });
    object.candidates = std::move(pieces);
}

}  // namespace partonomy
