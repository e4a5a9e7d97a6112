/* Candidate regions that end where colours change.
 *
 * find_parts cuts by shape, so the white bar of a sign and the red disc around it, flush in one plane, are one
 * candidate. Here each candidate falls into connected pieces of like colour. Two neighbouring triangles are alike when
 * their mean colours are no further apart than `alike`, or when they show the same image, whose colours are one
 * pattern. Pieces of less than a fiftieth of the candidate's area, such as the blurred border between two colours of
 * vertices, go to the neighbour with which they share most of their border. Stripes and checks are put together again:
 * where the colours of two neighbouring pieces both come back three times or more, they are one piece. Candidates of
 * one colour stay as they are. O(#T) for all candidates together, and the boxes of the new ones. */

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "algorithms/appearance.h"
#include "mesh/appearance.h"
#include "shape/part_box.h"

namespace partonomy {
namespace {

constexpr double alike = 0.08;        // distance in OKLab
constexpr double least_piece = 0.02;  // of the candidate's area
constexpr int comes_back = 3;
constexpr double flat = 0.8, same_side = 0.9;  // cosines between normals

using Triangles = std::vector<std::int32_t>;

class Splitter {
public:
    explicit Splitter(const Object& object)
        : object_(object),
          appearance_(*object.appearance),
          adjacency_(build_adjacency(object.mesh)),
          piece_of_(object.mesh.triangles.size(), -1) {
        colors_.reserve(piece_of_.size());
        for (std::size_t t = 0; t < piece_of_.size(); ++t) colors_.push_back(mean_color(t));
    }

    /// The pieces of a candidate, each ascending; one when it is of one colour.
    std::vector<Triangles> split(const Triangles& candidate) {
        pieces_.clear();
        for (const std::int32_t t : candidate) piece_of_[index(t)] = unvisited;
        for (const std::int32_t t : candidate)
            if (piece_of_[index(t)] == unvisited) grow(t);
        if (pieces_.size() > 1) merge_small(candidate);
        if (large_count_ > 1) merge_patterns(candidate);
        std::vector<Triangles> result;
        std::vector<std::int32_t> number(pieces_.size(), -1);
        for (const std::int32_t t : candidate) {
            const std::size_t piece = index(root(piece_of_[index(t)]));
            if (number[piece] < 0) {
                number[piece] = static_cast<std::int32_t>(result.size());
                result.emplace_back();
            }
            result[index(number[piece])].push_back(t);
        }
        for (const std::int32_t t : candidate) piece_of_[index(t)] = -1;
        return result;
    }

private:
    static constexpr std::int32_t unvisited = -2;
    struct Piece {
        std::int32_t into;  ///< the piece that it was merged into, or itself
        double area = 0;
        Lab color{0, 0, 0};
        bool is_known = false;
    };
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

    [[nodiscard]] Color mean_color(std::size_t t) const {
        const Eigen::Vector3f middle = Eigen::Vector3f::Constant(1.0F / 3);
        if (appearance_.is_plain(t)) return appearance_.color_at(t, middle);
        Color sum = Color::Zero();
        constexpr float far = 2.0F / 3, near = 1.0F / 6;
        for (const Eigen::Vector3f& weights : {Eigen::Vector3f(far, near, near), Eigen::Vector3f(near, far, near),
                                               Eigen::Vector3f(near, near, far), middle})
            sum += appearance_.color_at(t, weights) / 4;
        return sum;
    }

    [[nodiscard]] int image_of(std::size_t t) const {
        const Material* material = appearance_.material_of(t);
        return material ? material->image : -1;
    }

    [[nodiscard]] bool are_alike(std::size_t t, std::size_t u) const {
        if (image_of(t) >= 0 && image_of(t) == image_of(u)) return true;
        if (is_known(colors_[t]) != is_known(colors_[u])) return false;
        return !is_known(colors_[t]) || distance(lab_from_linear(colors_[t]), lab_from_linear(colors_[u])) <= alike;
    }

    void grow(std::int32_t start) {
        const auto number = static_cast<std::int32_t>(pieces_.size());
        Piece piece{number};
        Color sum = Color::Zero();
        Triangles open{start};
        piece_of_[index(start)] = number;
        while (!open.empty()) {
            const std::size_t t = index(open.back());
            open.pop_back();
            const double area = object_.geometry.areas[t];
            piece.area += area;
            if (is_known(colors_[t])) {
                sum += static_cast<float>(area) * colors_[t];
                piece.is_known = true;
            }
            for (const std::int32_t u : adjacency_.neighbours[t])
                if (u >= 0 && piece_of_[index(u)] == unvisited && are_alike(t, index(u))) {
                    piece_of_[index(u)] = number;
                    open.push_back(u);
                }
        }
        if (piece.area > 0) piece.color = lab_from_linear(sum / static_cast<float>(piece.area));
        pieces_.push_back(piece);
    }

    [[nodiscard]] std::int32_t root(std::int32_t piece) const {
        while (pieces_[index(piece)].into != piece) piece = pieces_[index(piece)].into;
        return piece;
    }

    /// Lengths of the borders between pieces that are not one yet.
    [[nodiscard]] std::map<std::pair<std::int32_t, std::int32_t>, double> borders(const Triangles& candidate) const {
        std::map<std::pair<std::int32_t, std::int32_t>, double> lengths;
        for (const std::int32_t t : candidate)
            for (std::size_t e = 0; e < 3; ++e) {
                const std::int32_t u = adjacency_.neighbours[index(t)][e];
                if (u < 0 || piece_of_[index(u)] < 0) continue;
                const std::int32_t a = root(piece_of_[index(t)]), b = root(piece_of_[index(u)]);
                if (a == b) continue;
                const auto& corners = object_.mesh.triangles[index(t)];
                lengths[{a, b}] +=
                    (object_.mesh.positions[index(corners[e])] - object_.mesh.positions[index(corners[(e + 1) % 3])])
                        .norm();
            }
        return lengths;
    }

    void merge_small(const Triangles& candidate) {
        const double total = std::accumulate(pieces_.begin(), pieces_.end(), 0.0,
                                             [](double sum, const Piece& piece) { return sum + piece.area; });
        const auto is_small = [&](std::int32_t piece) { return pieces_[index(piece)].area < least_piece * total; };
        large_count_ = 0;
        for (std::int32_t piece = 0; piece < static_cast<std::int32_t>(pieces_.size()); ++piece)
            large_count_ += !is_small(piece);
        if (large_count_ <= 1) {  // one colour, or too fine a mosaic
            for (Piece& piece : pieces_) piece.into = 0;
            return;
        }
        for (bool changed = true; changed;) {  // a small piece waits until a neighbour is large, or was taken by one
            changed = false;
            std::map<std::int32_t, std::pair<double, std::int32_t>> best;
            for (const auto& [pair, length] : borders(candidate)) {
                const auto& [small, other] = pair;
                if (!is_small(small) || is_small(other)) continue;
                auto& found = best.try_emplace(small, -1.0, -1).first->second;
                if (length > found.first) found = {length, other};
            }
            for (const auto& [small, found] : best) {
                pieces_[index(small)].into = found.second;
                changed = true;
            }
        }
        // What touches no large piece hangs loose; it stays with the first one, so that nothing gets lost.
        std::int32_t first = 0;
        while (is_small(first)) ++first;
        for (std::int32_t piece = 0; piece < static_cast<std::int32_t>(pieces_.size()); ++piece)
            if (root(piece) == piece && is_small(piece)) pieces_[index(piece)].into = first;
    }

    /// A flat side of a piece.
    struct Facet {
        std::int32_t piece;
        double area = 0;
        Vec3 normal = Vec3::Zero();  ///< sum by area
    };

    std::vector<Facet> facets(const Triangles& candidate) const {
        std::vector<Facet> all;
        std::set<std::int32_t> left(candidate.begin(), candidate.end());
        while (!left.empty()) {
            Facet facet{root(piece_of_[index(*left.begin())])};
            Triangles open{*left.begin()};
            left.erase(left.begin());
            while (!open.empty()) {
                const std::size_t t = index(open.back());
                open.pop_back();
                const Vec3& normal = object_.geometry.normals[t];
                facet.area += object_.geometry.areas[t];
                facet.normal += object_.geometry.areas[t] * normal;
                for (const std::int32_t u : adjacency_.neighbours[t])
                    if (left.contains(u) && root(piece_of_[index(u)]) == facet.piece &&
                        normal.dot(object_.geometry.normals[index(u)]) > flat) {
                        left.erase(u);
                        open.push_back(u);
                    }
            }
            all.push_back(facet);
        }
        return all;
    }

    /// Joins neighbours that are both repeated: most of their area is flat sides of a colour that comes back on the
    /// same side of the candidate.
    void merge_patterns(const Triangles& candidate) {
        const double total = std::accumulate(pieces_.begin(), pieces_.end(), 0.0,
                                             [](double sum, const Piece& piece) { return sum + piece.area; });
        std::vector<Facet> all = facets(candidate);
        std::erase_if(all, [&](const Facet& facet) { return facet.area < least_piece * total; });
        std::vector<double> area(pieces_.size(), 0.0), repeated(pieces_.size(), 0.0);
        for (const std::int32_t t : candidate)
            area[index(root(piece_of_[index(t)]))] += object_.geometry.areas[index(t)];
        for (const Facet& facet : all) {
            const Piece& piece = pieces_[index(facet.piece)];
            const auto count = std::ranges::count_if(all, [&](const Facet& other) {
                const Piece& its = pieces_[index(other.piece)];
                return piece.is_known && its.is_known && distance(piece.color, its.color) <= alike &&
                       facet.normal.normalized().dot(other.normal.normalized()) > same_side;
            });
            if (count >= comes_back) repeated[index(facet.piece)] += facet.area;
        }
        const auto is_repeated = [&](std::int32_t piece) { return repeated[index(piece)] > area[index(piece)] / 2; };
        std::vector<std::pair<std::int32_t, std::int32_t>> joined;
        for (const auto& [pair, length] : borders(candidate))
            if (is_repeated(pair.first) && is_repeated(pair.second)) joined.push_back(pair);
        for (const auto& pair : joined) {
            const std::int32_t a = root(pair.first), b = root(pair.second);
            if (a != b) pieces_[index(std::max(a, b))].into = std::min(a, b);
        }
    }

    const Object& object_;
    const Appearance& appearance_;
    Adjacency adjacency_;
    std::vector<Color> colors_;
    std::vector<std::int32_t> piece_of_;  ///< -1 outside of the candidate in turn
    std::vector<Piece> pieces_;
    int large_count_ = 0;
};

}  // namespace

void split_by_color(Object& object) {
    Splitter splitter(object);
    std::vector<PartRegion> result;
    for (PartRegion& candidate : object.candidates) {
        std::vector<Triangles> pieces = splitter.split(candidate.region.triangles);
        if (pieces.size() <= 1) {
            result.push_back(std::move(candidate));
            continue;
        }
        for (Triangles& triangles : pieces) {
            PartBox measured = measure_part(object.mesh, object.geometry, triangles, object.is_noisy);
            result.push_back(
                {{std::move(triangles), std::move(measured.memberships)}, measured.box, measured.fit, object.is_noisy});
        }
    }
    std::ranges::sort(result, {}, [](const PartRegion& part) { return part.region.triangles.front(); });
    object.candidates = std::move(result);
}

}  // namespace partonomy
