/* Up axis and unit, where the user does not tell them.
 *
 * Each of the six axis directions is tried as up (and each unit): the object is questioned as usual, which takes a
 * fraction of a millisecond for a few parts, since cutting depends on up no more than in the corners of flush boards. A
 * placement is plausible when the object stands firmly (shape/resting.h), when it is something the ontology knows and
 * nothing forbids, when much of its surface has a name, when one side is the mirror image of the other (what stands
 * mostly has an upright mirror plane; what lies often has none), and when its height is typical of what it is
 * (core:typicalHeight, a trapezoid in metres at the concepts of objects). Files are rarely upside down, so the negative
 * axes count a little less. The product of these counts, and the confidence is the best placement's share of the best
 * and the next together. A unit that is not clearly more plausible than the others is not set: questions that need it
 * stay open. */

#include "expert/place.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "shape/membership.h"
#include "shape/resting.h"

namespace partonomy {
namespace {

constexpr std::array<const char*, 6> up_words = {"x", "-x", "y", "-y", "z", "-z"};
constexpr std::array<const char*, 4> unit_words = {"m", "cm", "mm", "in"};
constexpr double trusted = 0.7;                                         // confidence of a unit, at least
constexpr double least_plausible = 0.05;                                // of a unit's best placement
constexpr double unrecognised = 0.1, forbidden = 0.9, toppling = 0.05;  // what each takes off
constexpr double upside_down = 0.96, lopsided = 0.2;

/// Trapezoids of core:typicalHeight by the local name of the concept.
std::map<std::string, Trapezoid> typical_heights(const knowledge::Domain& domain) {
    std::map<std::string, Trapezoid> heights;
    for (const auto& [iri, height] : domain.typical_heights)
        heights[owl::local_name(iri)] = {height.a1, height.a2, height.a3, height.a4};
    return heights;
}

/// Whether two boxes have alike sides.
bool are_alike(const OrientedBox& a, const OrientedBox& b) {
    constexpr double most = 1.15;
    return (a.lengths.array() <= most * b.lengths.array()).all() &&
           (b.lengths.array() <= most * a.lengths.array()).all();
}

/// Per axis the share of the surface whose region has a like one (or is itself) where the mirror across the middle of
/// the axis shows it.
std::array<double, 3> mirrored_shares(const Object& object) {
    if (object.mesh.triangles.empty()) return {};
    const Bounds bounds = compute_used_bounds(object.mesh);
    const Vec3 middle = bounds.middle();
    const double slack = 0.05 * bounds.diagonal();
    std::vector<Vec3> centres;
    std::vector<double> areas;
    double all = 0;
    for (const PartRegion& part : object.candidates) {
        Vec3 sum = Vec3::Zero();
        double area = 0;
        for (const std::int32_t triangle : part.region.triangles) {
            const auto t = static_cast<std::size_t>(triangle);
            sum += object.geometry.areas[t] * object.geometry.barycentres[t];
            area += object.geometry.areas[t];
        }
        centres.push_back(area > 0 ? Vec3(sum / area) : part.box.centre);
        areas.push_back(area);
        all += area;
    }
    std::array<double, 3> shares{};
    for (std::size_t axis = 0; all > 0 && axis < 3; ++axis)
        for (std::size_t i = 0; i < centres.size(); ++i) {
            const auto a = static_cast<Eigen::Index>(axis);
            Vec3 image = centres[i];
            image[a] = 2 * middle[a] - image[a];
            for (std::size_t j = 0; j < centres.size(); ++j)
                if ((centres[j] - image).norm() < slack &&
                    are_alike(object.candidates[i].box, object.candidates[j].box)) {
                    shares[axis] += areas[i] / all;
                    break;
                }
        }
    return shares;
}

/// Where an object is put on trial.
class Trial {
public:
    Trial(const knowledge::Domain& domain, const Catalogue& catalogue, Object& object)
        : domain_(domain),
          catalogue_(catalogue),
          object_(object),
          resting_(resting_scores(object.mesh, object.geometry)),
          mirrored_(mirrored_shares(object)),
          typical_(typical_heights(domain)) {}

    /// `by_size`: the unit is on trial, too.
    double plausibility(std::size_t up, std::optional<double> metres_per_unit, bool by_size) {
        place(object_, {axis_directions()[up], metres_per_unit});
        by_size = by_size && metres_per_unit.has_value();
        if (by_size && !is_of_any_size(*metres_per_unit)) return 0;
        AnnotateOptions quick;
        quick.diagnose = quick.mend = false;
        const Annotation annotation = annotate(domain_, catalogue_, object_, quick);
        const std::size_t axis = up / 2;
        const double mirrored = std::max(mirrored_[(axis + 1) % 3], mirrored_[(axis + 2) % 3]);
        double score = annotation.score * std::max(toppling, resting_[up]) * (lopsided + (1 - lopsided) * mirrored);
        if (up % 2 == 1) score *= upside_down;
        bool is_recognised = false;
        double size = 0;
        for (const std::string& name : annotation.classes) {
            const auto found = typical_.find(name);
            is_recognised |= found != typical_.end();
            if (found != typical_.end() && by_size)
                size = std::max(size, found->second(*metres_per_unit * (object_.high - object_.low)));
        }
        if (!is_recognised && !typical_.empty()) score *= unrecognised;
        if (!annotation.consistent) score *= forbidden;
        return by_size && is_recognised ? score * std::max(unrecognised, size) : score;
    }

    /// Whether anything that the ontology knows is as high; saves questioning a chair of 90 metres.
    [[nodiscard]] bool is_of_any_size(double metres_per_unit) const {
        const double height = metres_per_unit * (object_.high - object_.low);
        return typical_.empty() ||
               std::ranges::any_of(typical_, [&](const auto& each) { return each.second(height) > 0; });
    }

private:
    const knowledge::Domain& domain_;
    const Catalogue& catalogue_;
    Object& object_;
    std::array<double, 6> resting_;
    std::array<double, 3> mirrored_;
    std::map<std::string, Trapezoid> typical_;
};

double share(double best, double next) { return best > 0 ? best / (best + next) : 0; }

}  // namespace

Vec3 resting_up(const TriangleMesh& mesh) {
    const std::array<double, 6> scores = resting_scores(mesh, compute_geometry(mesh));
    return axis_directions()[static_cast<std::size_t>(std::ranges::max_element(scores) - scores.begin())];
}

Placing find_placement(const knowledge::Domain& domain, const Catalogue& catalogue, Object& object,
                       const PlacingOptions& options) {
    Placing placing{options.up, options.unit == "auto" ? "unknown" : options.unit, 1, 1};
    const Vec3 cut_up = object.placement.up;
    const bool find_up = options.up == "auto", find_unit = options.unit == "auto";
    std::vector<std::optional<double>> units;
    if (find_unit)
        for (const char* word : unit_words) units.push_back(parse_unit(word));
    else
        units.push_back(object.placement.metres_per_unit);
    Trial trial(domain, catalogue, object);
    std::vector<std::array<double, 6>> scores(units.size());  // by unit and direction
    for (std::size_t unit = 0; unit < units.size(); ++unit)
        for (std::size_t up = 0; up < up_words.size(); ++up)
            scores[unit][up] =
                !find_up && axis_directions()[up] != cut_up ? 0 : trial.plausibility(up, units[unit], find_unit);
    if (find_unit) {
        std::vector<std::pair<double, std::size_t>> best;  // of each unit
        for (std::size_t unit = 0; unit < units.size(); ++unit)
            best.emplace_back(*std::ranges::max_element(scores[unit]), unit);
        std::ranges::stable_sort(best, std::greater<>(), &std::pair<double, std::size_t>::first);
        placing.unit_confidence = share(best[0].first, best[1].first);
        if (best[0].first >= least_plausible && placing.unit_confidence >= trusted) {
            placing.unit = unit_words[best[0].second];
            units = {units[best[0].second]};
            scores = {scores[best[0].second]};
        } else {  // no unit: the axis must be found without one
            units = {std::nullopt};
            scores.assign(1, {});
            for (std::size_t up = 0; up < up_words.size(); ++up)
                if (find_up) scores[0][up] = trial.plausibility(up, std::nullopt, false);
        }
    }
    Placement placement{cut_up, units.front()};
    if (find_up) {
        std::array<double, 6> sorted = scores.front();
        const auto best = static_cast<std::size_t>(std::ranges::max_element(sorted) - sorted.begin());
        placement.up = axis_directions()[best];
        placing.up = up_words[best];
        std::ranges::sort(sorted, std::greater<>());
        placing.up_confidence = share(sorted[0], sorted[1]);
    }
    place(object, placement);
    if (std::abs(placement.up.dot(cut_up)) < 0.5) cut(object, options.threads);
    return placing;
}

}  // namespace partonomy
