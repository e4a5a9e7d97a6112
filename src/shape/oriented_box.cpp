// The smallest oriented box, by exact rectangles in many planes.
//
// Idea: when one axis of the box is known, the other two follow exactly: the smallest rectangle around the points'
// shadow in the plane across it (2D hull, then one side of the rectangle lies on a hull edge). So a box is improved by
// turning it about each of its axes in turn to the exact best angle, until nothing is gained. O'Rourke (1985) shows
// that the optimum has two neighbouring faces flush with hull edges. What such turns cannot reach, a search over one
// axis alone does: the best box about an axis is a function on the sphere with two parameters, and a downhill simplex
// (Nelder and Mead 1965) leads to its nearest valley. Starts are the principal axes, directions spread over the sphere
// as the points are, and for eight points or fewer the normals of all their triangles. Only starts that come near the
// best go on: one for a board, up to four for a cloud.
//
// Cost: only the points that are extreme along one of the spread directions take part (a few hundred at most), and more
// of them in clouds and balls, where many boxes are nearly as small and each corner of the hull counts; all points are
// measured against the result, those that stick out join, and the last steps are repeated. So the box holds
// every point, and n enters linearly. PCA alone was left: on the cube of the paper's Fig. 16 its box is 3 times too
// large.

#include "shape/oriented_box.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "shape/rectangle.h"

namespace partonomy {

namespace {

using Eigen::Matrix3d;
using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;

struct Turned {
    Matrix3d axes;
    double volume;
};

/// Directions spread evenly over half the sphere (a Fibonacci spiral), the coordinate axes first.
Points spread_directions(int count) {
    Points directions(3, count + 3);
    directions.leftCols<3>().setIdentity();
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int k = 0; k < count; ++k) {
        const double z = (k + 0.5) / count, r = std::sqrt(1 - z * z);
        directions.col(k + 3) << r * std::cos(golden * k), r * std::sin(golden * k), z;
    }
    return directions;
}

Vec3 extents(const Points& points, const Matrix3d& axes) {
    Vec3 low = axes.transpose() * points.col(0), high = low;
    for (Eigen::Index i = 1; i < points.cols(); ++i) {
        const Vec3 p = axes.transpose() * points.col(i);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return high - low;
}

/// Whether points lie in all eight corners of the box with these axes: then it is the hull itself, and the smallest.
bool fills_its_corners(const Points& points, const Matrix3d& axes, double size) {
    const Points turned = axes.transpose() * points;
    const Vec3 low = turned.rowwise().minCoeff(), high = turned.rowwise().maxCoeff();
    unsigned corners = 0;
    for (Eigen::Index i = 0; i < turned.cols(); ++i) {
        const Eigen::Array3d above = (turned.col(i) - low).array(), below = (high - turned.col(i)).array();
        if ((above.min(below) > 1e-9 * size).any()) continue;
        const Eigen::Array<bool, 3, 1> is_high = below < above;
        corners |= 1U << (is_high[0] + 2 * is_high[1] + 4 * is_high[2]);
    }
    return corners == 0xffU;
}

/// Volume that still tells flat sets apart: sides are counted as at least a billionth of the size.
double padded_volume(const Vec3& sides, double size) { return (sides.array() + 1e-9 * size).prod(); }

constexpr int most_turns = 60;  // flat sets would creep on: each turn gains a little of next to nothing
constexpr int most_descents = 60;
constexpr double least_lean = 1e-5;  // radians: a simplex smaller than this has settled
constexpr double least_gain = 1e-5;  // a round of improving that gains less is the last

class Search {
public:
    Search(const Points& points, double size) : points_(points), size_(size) {}

    /// The best box with one axis along `axis`.
    Turned about(const Vec3& axis) {
        const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
        shadow_.resize(static_cast<std::size_t>(points_.cols()));
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (Eigen::Index i = 0; i < points_.cols(); ++i) {
            shadow_[static_cast<std::size_t>(i)] = {points_.col(i).dot(x), points_.col(i).dot(y)};
            const double along = points_.col(i).dot(axis);
            low = std::min(low, along);
            high = std::max(high, along);
        }
        convex_hull(shadow_, hull_);
        const Rectangle rectangle = smallest_rectangle(hull_, size_);
        Turned turned;
        turned.axes.col(0) = axis;
        turned.axes.col(1) = (rectangle.side.x * x + rectangle.side.y * y).normalized();
        turned.axes.col(2) = turned.axes.col(0).cross(turned.axes.col(1));
        turned.volume = rectangle.area == std::numeric_limits<double>::infinity()
                            ? padded_volume(extents(points_, turned.axes), size_)
                            : rectangle.area * (high - low + 1e-9 * size_);
        return turned;
    }

    /// Moves the box's first axis to where the best box about it is smallest nearby, then turns about all three; again
    /// while that gains.
    void improve(Turned& box) {
        for (const double step : {0.1, 0.025, 0.025}) {
            const double before = box.volume;
            descend(box, step);
            turn_exactly(box);
            if (box.volume > before * (1 - least_gain)) break;
        }
    }

    void turn_exactly(Turned& box) {
        for (int idle = 0, axis = 0, turns = 0; idle < 3 && turns < most_turns; axis = (axis + 1) % 3, ++turns) {
            const Turned turned = about(box.axes.col(axis));
            const bool gain = turned.volume < box.volume * (1 - 1e-9);
            if (gain) box = turned;
            idle = gain ? 1 : idle + 1;
            if (gain) axis = 0;  // column 0 is the axis just turned about
        }
    }

private:
    /// The best box about an axis that leans from the first box's by (u, v).
    struct Leaning {
        double u = 0, v = 0;
        Turned box;
    };

    /// Downhill simplex over the sphere of axes, from a triangle with sides of `step` radians.
    void descend(Turned& box, double step) {
        const Matrix3d axes = box.axes;
        const auto lean = [&](double u, double v) {
            return Leaning{u, v, about((axes.col(0) + u * axes.col(1) + v * axes.col(2)).normalized())};
        };
        std::array<Leaning, 3> corners{Leaning{0, 0, box}, lean(step, 0), lean(0, step)};
        auto& [best, middle, worst] = corners;
        const auto sort = [&] {
            std::stable_sort(corners.begin(), corners.end(),
                             [](const Leaning& a, const Leaning& b) { return a.box.volume < b.box.volume; });
        };
        sort();
        for (int round = 0; round < most_descents; ++round) {
            const double width = std::max(std::hypot(middle.u - best.u, middle.v - best.v),
                                          std::hypot(worst.u - best.u, worst.v - best.v));
            if (width < least_lean || worst.box.volume < best.box.volume * (1 + 1e-8)) break;
            const double u = (best.u + middle.u) / 2, v = (best.v + middle.v) / 2;
            const auto beyond = [&](double times) {
                return lean(u + times * (u - worst.u), v + times * (v - worst.v));
            };
            const Leaning across = beyond(1);
            if (across.box.volume < best.box.volume) {
                const Leaning farther = beyond(2);
                worst = farther.box.volume < across.box.volume ? farther : across;
            } else if (across.box.volume < middle.box.volume) {
                worst = across;
            } else {
                const Leaning nearer = beyond(across.box.volume < worst.box.volume ? 0.5 : -0.5);
                if (nearer.box.volume < std::min(across.box.volume, worst.box.volume)) {
                    worst = nearer;
                } else {
                    middle = lean((best.u + middle.u) / 2, (best.v + middle.v) / 2);
                    worst = lean((best.u + worst.u) / 2, (best.v + worst.v) / 2);
                }
            }
            sort();
        }
        if (best.box.volume < box.volume) box = best.box;
    }

    const Points& points_;
    double size_;
    std::vector<Planar> shadow_, hull_;
};

constexpr Eigen::Index most_points_for_triples = 8;
constexpr std::size_t most_points_at_once = 12;  // of more, those that are extreme somewhere take part first
constexpr std::size_t most_left_out = 4;         // of that many points, one is extreme: all take part
constexpr std::size_t fine_mesh = 10'000;        // points: boxes of round things are alike whichever points are missed
constexpr Eigen::Index few_corners = 32, many_corners = 200;

/// How many directions boxes start from, and how many of them go on.
struct Effort {
    int directions;
    std::size_t starts, improved;
};
constexpr Effort quick{40, 8, 4}, thorough{60, 12, 4}, brief{40, 8, 2};

constexpr double too_large_to_turn = 1.5;      // times the smallest start
constexpr double too_large_to_improve = 1.03;  // times the smallest turned box
constexpr double round_reach = 0.62;           // into the corners of the box: a ball's is 0.58
constexpr double second_chance = 1.01;         // a second box this near in volume may turn out to be the smaller one

/// What points have along directions: the smallest and largest values, and whose they are.
class Extremes {
public:
    Extremes(std::span<const Vec3> points, const Points& directions)
        : points_(points.data()->data(), 3, static_cast<Eigen::Index>(points.size())),
          directions_(directions),
          low_(Eigen::VectorXd::Constant(directions.cols(), std::numeric_limits<double>::infinity())),
          high_(-low_),
          lowest_(static_cast<std::size_t>(directions.cols())),
          highest_(lowest_) {}

    /// Numbers of the points that are extreme along one of the directions, ascending. Points that follow each other
    /// mostly lie near each other: a block of them is looked at along a direction only where its bounds reach beyond
    /// what some points spread over the whole are known to reach.
    std::vector<Eigen::Index> find() {
        know_some();
        Eigen::VectorXd along(block);
        for (Eigen::Index start = 0; start < points_.cols(); start += block) {
            const auto some = points_.middleCols(start, std::min(block, points_.cols() - start));
            const Vec3 low = some.rowwise().minCoeff(), high = some.rowwise().maxCoeff();
            const Vec3 middle = (low + high) / 2, half = (high - low) / 2;
            for (Eigen::Index d = 0; d < directions_.cols(); ++d) {
                const auto direction = directions_.col(d);
                const double at = middle.dot(direction), reach = half.dot(direction.cwiseAbs()) + slack_;
                const bool may_be_high = at + reach > std::max(high_[d], known_high_[d]);
                const bool may_be_low = at - reach < std::min(low_[d], known_low_[d]);
                if (!may_be_high && !may_be_low) continue;
                auto values = along.head(some.cols());
                values.noalias() = some.transpose() * direction;
                take(d, start, values);
            }
        }
        std::vector<Eigen::Index> extreme = lowest_;
        extreme.insert(extreme.end(), highest_.begin(), highest_.end());
        std::sort(extreme.begin(), extreme.end());
        extreme.erase(std::unique(extreme.begin(), extreme.end()), extreme.end());
        return extreme;
    }

private:
    static constexpr Eigen::Index block = 64, samples = 64;

    void know_some() {
        const Eigen::Index stride = 1 + points_.cols() / samples, count = (points_.cols() - 1) / stride + 1;
        Points some(3, count);
        for (Eigen::Index k = 0; k < count; ++k) some.col(k) = points_.col(k * stride);
        const Eigen::MatrixXd along = some.transpose() * directions_;
        known_low_ = along.colwise().minCoeff();
        known_high_ = along.colwise().maxCoeff();
        slack_ = 1e-12 * some.cwiseAbs().maxCoeff();  // more than rounding
        known_low_.array() += slack_;
        known_high_.array() -= slack_;
    }

    template <class Values>
    void take(Eigen::Index d, Eigen::Index start, const Values& values) {
        Eigen::Index at = 0;
        if (const double smallest = values.minCoeff(); smallest < low_[d]) {
            values.minCoeff(&at);
            low_[d] = smallest;
            lowest_[static_cast<std::size_t>(d)] = start + at;
        }
        if (const double largest = values.maxCoeff(); largest > high_[d]) {
            values.maxCoeff(&at);
            high_[d] = largest;
            highest_[static_cast<std::size_t>(d)] = start + at;
        }
    }

    Eigen::Map<const Points> points_;
    const Points& directions_;
    Eigen::VectorXd low_, high_, known_low_, known_high_;
    std::vector<Eigen::Index> lowest_, highest_;
    double slack_ = 0;
};

std::vector<Eigen::Index> extreme_points(std::span<const Vec3> points, const Points& directions) {
    return Extremes(points, directions).find();
}

Points gather(std::span<const Vec3> points, const std::vector<Eigen::Index>& chosen) {
    Points gathered(3, static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t i = 0; i < chosen.size(); ++i)
        gathered.col(static_cast<Eigen::Index>(i)) = points[static_cast<std::size_t>(chosen[i])];
    return gathered;
}

struct Principal {
    Matrix3d axes;
    Vec3 spreads;  ///< standard deviations, at least a thousandth of the largest
};

Principal principal_axes(const Points& points) {
    const Points centred = points.colwise() - Vec3(points.rowwise().mean());
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(centred * centred.transpose());
    const Vec3 spreads = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return {eigen.eigenvectors(), spreads.cwiseMax(1e-3 * spreads.maxCoeff())};
}

/// Fixed directions as they would be if the points were as wide as long: in flat or thin sets most of the hull looks
/// along the short axes.
Points fitted_directions(const Points& fixed, const Principal& principal) {
    Points fitted = principal.axes * (principal.spreads.cwiseInverse().asDiagonal() * fixed);
    fitted.colwise().normalize();
    return fitted;
}

/// Numbers of the points that are extreme along one of so many fitted directions. Points that lie nearer to the middle
/// than what is known of the set reaches along every direction need no look.
std::vector<Eigen::Index> corners_of(std::span<const Vec3> points, const std::vector<Eigen::Index>& known, int count) {
    const Points directions = spread_directions(count);
    const Eigen::Map<const Points> all(points.data()->data(), 3, static_cast<Eigen::Index>(points.size()));
    const Principal principal = principal_axes(all);
    const Points round = principal.spreads.cwiseInverse().asDiagonal() * principal.axes.transpose() *
                         (all.colwise() - Vec3(all.rowwise().mean()));
    const Eigen::MatrixXd along = round(Eigen::all, known).transpose() * directions;
    const double reach = std::min(along.colwise().maxCoeff().minCoeff(), -along.colwise().minCoeff().maxCoeff());
    std::vector<Eigen::Index> outer;
    std::vector<Vec3> candidates;
    for (Eigen::Index i = 0; i < round.cols(); ++i)
        if (round.col(i).norm() >= reach) {
            outer.push_back(i);
            candidates.emplace_back(round.col(i));
        }
    std::vector<Eigen::Index> corners = extreme_points(candidates, directions);
    for (Eigen::Index& i : corners) i = outer[static_cast<std::size_t>(i)];
    return corners;
}

/// The three axes, and directions up to a tenth of a radian away from them.
Points directions_near(const Matrix3d& axes) {
    Points directions(3, 27);
    int column = 0;
    for (int k = 0; k < 3; ++k)
        for (const double u : {-0.1, 0.0, 0.1})
            for (const double v : {-0.1, 0.0, 0.1})
                directions.col(column++) =
                    (axes.col(k) + u * axes.col((k + 1) % 3) + v * axes.col((k + 2) % 3)).normalized();
    return directions;
}

OrientedBox measured_box(std::span<const Vec3> points, const Matrix3d& axes) {
    Vec3 low = axes.transpose() * points.front(), high = low;
    for (const Vec3& point : points) {
        const Vec3 p = axes.transpose() * point;
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vec3 sides = high - low;
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sides[a] > sides[b]; });
    OrientedBox box;
    box.centre = axes * ((low + high) / 2);
    for (int k = 0; k < 3; ++k) {
        box.axes.col(k) = axes.col(order[static_cast<std::size_t>(k)]);
        box.lengths[k] = sides[order[static_cast<std::size_t>(k)]];
    }
    if (box.axes.determinant() < 0) box.axes.col(2) *= -1;
    return box;
}

/// Whether two boxes lie nearly alike, whichever of their axes is called first.
bool are_alike(const Matrix3d& a, const Matrix3d& b) {
    const Matrix3d cosines = (a.transpose() * b).cwiseAbs();
    return cosines.rowwise().maxCoeff().minCoeff() > 0.97;
}

/// The starts: boxes about the principal axes, spread directions and, in small sets, across every triangle of points.
/// The best ones, no two alike.
std::vector<Turned> starting_boxes(Search& search, const Points& points, const Effort& effort) {
    std::vector<Turned> all;
    const Principal principal = principal_axes(points);
    for (int k = 0; k < 3; ++k) all.push_back(search.about(principal.axes.col(k)));
    const Points directions = fitted_directions(spread_directions(effort.directions), principal);
    for (Eigen::Index d = 0; d < directions.cols(); ++d) all.push_back(search.about(directions.col(d)));
    if (points.cols() <= most_points_for_triples)
        for (Eigen::Index i = 0; i < points.cols(); ++i)
            for (Eigen::Index j = i + 1; j < points.cols(); ++j)
                for (Eigen::Index k = j + 1; k < points.cols(); ++k) {
                    const Vec3 p = points.col(i), u = points.col(j) - p, v = points.col(k) - p;
                    const Vec3 normal = u.cross(v);
                    if (normal.norm() > 1e-9 * u.norm() * v.norm()) all.push_back(search.about(normal.normalized()));
                }
    std::stable_sort(all.begin(), all.end(), [](const Turned& a, const Turned& b) { return a.volume < b.volume; });
    std::vector<Turned> starts;
    for (const Turned& box : all) {
        if (std::any_of(starts.begin(), starts.end(), [&](const Turned& s) { return are_alike(s.axes, box.axes); }))
            continue;
        starts.push_back(box);
        if (starts.size() == effort.starts) break;
    }
    return starts;
}

/// Sorts by volume; keeps at most `most`, and none more than `times` as large as the smallest.
void keep_small(std::vector<Turned>& boxes, std::size_t most, double times) {
    std::stable_sort(boxes.begin(), boxes.end(), [](const Turned& a, const Turned& b) { return a.volume < b.volume; });
    boxes.resize(std::min(boxes.size(), most));
    while (boxes.back().volume > times * boxes.front().volume) boxes.pop_back();
}

/// The smallest boxes of some points, no more than a little larger than the smallest.
std::vector<Turned> search_boxes(const Points& points, double size, const Effort& effort) {
    Search search(points, size);
    std::vector<Turned> boxes = starting_boxes(search, points, effort);
    if (fills_its_corners(points, boxes.front().axes, size)) return {boxes.front()};
    keep_small(boxes, effort.starts, too_large_to_turn);
    for (Turned& box : boxes) search.turn_exactly(box);
    keep_small(boxes, effort.improved, too_large_to_improve);
    for (Turned& box : boxes) search.improve(box);
    keep_small(boxes, effort.improved, too_large_to_improve);
    return boxes;
}

/// How far points reach into the corners of their box, on the mean of its diagonals: 1 for a box, 0.8 for a round stick
/// or plate, 0.58 for a ball.
double corner_reach(const Points& points, const Matrix3d& axes) {
    const Points turned = axes.transpose() * points;
    const Vec3 low = turned.rowwise().minCoeff(), high = turned.rowwise().maxCoeff();
    double sum = 0;
    for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0}) {
            const Vec3 diagonal = Vec3(1, y, z).cwiseQuotient((high - low).cwiseMax(1e-12 * (high - low).norm()));
            const Eigen::RowVectorXd along = diagonal.transpose() * turned;
            sum += along.maxCoeff() - along.minCoeff();
        }
    return sum / 12;
}

}  // namespace

OrientedBox smallest_box(std::span<const Vec3> points) {
    if (points.empty()) throw std::invalid_argument("smallest_box needs at least one point.");
    static const Points fixed = spread_directions(80);
    std::vector<Eigen::Index> chosen;
    if (points.size() > most_points_at_once) {
        const Eigen::Map<const Points> all(points.data()->data(), 3, static_cast<Eigen::Index>(points.size()));
        chosen = extreme_points(points, fitted_directions(fixed, principal_axes(all)));
    }
    if (points.size() < most_left_out * chosen.size() || chosen.empty()) {
        chosen.resize(points.size());
        std::iota(chosen.begin(), chosen.end(), 0);
    }
    Points active = gather(points, chosen);
    const double size = (active.rowwise().maxCoeff() - active.rowwise().minCoeff()).norm();
    if (!(size > 0)) return measured_box(points, Matrix3d::Identity());
    if (const Matrix3d axes = principal_axes(active).axes; fills_its_corners(active, axes, size))
        return measured_box(points, axes);

    std::vector<Turned> boxes = search_boxes(active, size, active.cols() < few_corners ? thorough : quick);
    if (boxes.size() > 1 && corner_reach(active, boxes.front().axes) < round_reach) {
        // In clouds and balls, boxes that lie otherwise are nearly as small: all corners of the hull must tell.
        if (chosen.size() < points.size()) {
            chosen = corners_of(points, chosen, points.size() < fine_mesh ? 5120 : 640);
            active = gather(points, chosen);
        }
        boxes = search_boxes(active, size, active.cols() < many_corners ? thorough : brief);
    }
    keep_small(boxes, 2, second_chance);
    if (chosen.size() == points.size()) return measured_box(points, boxes.front().axes);

    // The points that were left out may stick out: those extreme along the box's axes, and along directions near them,
    // join.
    for (Turned& box : boxes)
        for (int round = 0; round < 3; ++round) {
            const double whole = padded_volume(measured_box(points, box.axes).lengths, size);
            const bool holds_all = whole <= box.volume * (1 + 1e-9);
            box.volume = whole;
            if (holds_all) break;
            const std::size_t before = chosen.size();
            const std::vector<Eigen::Index> more = extreme_points(points, directions_near(box.axes));
            chosen.insert(chosen.end(), more.begin(), more.end());
            std::sort(chosen.begin(), chosen.end());
            chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
            active = gather(points, chosen);
            box.volume = padded_volume(extents(active, box.axes), size);
            if (chosen.size() == before) break;
            Search(active, size).improve(box);
        }
    const Turned& best = *std::min_element(boxes.begin(), boxes.end(),
                                           [](const Turned& a, const Turned& b) { return a.volume < b.volume; });
    return measured_box(points, best.axes);
}

}  // namespace partonomy
