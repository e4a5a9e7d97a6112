// Four samples a pixel, in bands of a few rows that threads take one by one.
//
// A depth buffer (samples.h) knows the triangle in front at each sample. Two samples beside each other are split when
// they show different parts, or when one surface, continued as a plane, misses the other by more than 2 % of the
// object: both become a dark line. The mean of the four samples is the pixel: smooth edges and smooth lines.
//
// On a closed surface what faces away is hidden by what faces the camera, so it is left out.
//
// A band looks one sample beyond itself on each side, so its pixels depend on nothing outside of it. Only a band's own
// triangles are set up at a time: memory is three numbers a vertex and one a triangle.

#include "report/draw_object.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/ranges.h"
#include "report/samples.h"

namespace partonomy {
namespace {

constexpr Color white{255, 255, 255}, ink{38, 38, 44};
constexpr double depth_jump = 0.02;
constexpr int block = 16;                             // samples looked at together
constexpr int band_height = 12;                       // pixels
constexpr double nudge_x = 0.0137, nudge_y = 0.0071;  // keeps samples off the edges of symmetric objects

/// A triangle as the camera sees it.
struct Facet {
    Color color = white;
    std::int32_t part = -1;
    DepthPlane plane;
};

Color shaded(Color color, double light) {
    for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(std::clamp(static_cast<int>(channel * light + 0.5), 0, 255));
    return color;
}

/// Light from above and from the viewer's left shoulder, and some from everywhere. Vectors in the camera's frame.
struct Lamps {
    Vec3 shoulder, above;

    Lamps(const Camera& camera, const Vec3& up)
        : shoulder(Vec3(-0.55, -0.25, -1).normalized()),
          above(up.dot(camera.right), up.dot(camera.down), up.dot(camera.into)) {}

    [[nodiscard]] double on(const Vec3& normal) const {
        return 0.54 + 0.40 * std::max(0.0, normal.dot(shoulder)) + 0.16 * std::max(0.0, normal.dot(above));
    }
};

/// Whether every edge runs as often one way as the other: a fingerprint per edge, added for one way and taken away for
/// the other, leaves nothing (of surfaces that are open, one in 2^64 is taken for closed).
bool is_closed(const TriangleMesh& mesh) {
    std::uint64_t sum = 0;
    for (const std::array<std::int32_t, 3>& corners : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto from = static_cast<std::uint64_t>(corners[i]),
                       to = static_cast<std::uint64_t>(corners[(i + 1) % 3]);
            std::uint64_t edge = (std::min(from, to) << 32 | std::max(from, to)) * 0x9e3779b97f4a7c15U;
            edge = (edge ^ edge >> 29) * 0xbf58476d1ce4e5b9U;
            edge ^= edge >> 32;
            sum += from < to ? edge : 0 - edge;
        }
    return sum == 0;
}

/// What is drawn: the mesh through the camera, its points in samples (two a pixel) of the frame.
struct Scene {
    const TriangleMesh& mesh;
    const Annotation& annotation;
    Lamps lamps;
    double scale;            ///< samples for a length of 1
    std::vector<Vec3> seen;  ///< per vertex: column, row, depth
    std::vector<Color> part_colors;
    std::vector<std::vector<std::int32_t>> bands;  ///< triangles of each band

    Scene(const TriangleMesh& m, const PlacedMesh& placed, const Annotation& a, const Camera& camera, const Vec3& up,
          const Frame& frame)
        : mesh(m), annotation(a), lamps(camera, up), scale(2 * camera.scale), seen(m.positions.size()) {
        for (const AnnotatedPart& part : a.parts) part_colors.push_back(color_of(part));
        const Vec3 corner(frame.left + 0.25 + nudge_x, frame.top + 0.25 + nudge_y, 0);  // the first sample
        for (std::size_t v = 0; v < seen.size(); ++v) {
            seen[v] = camera.see(placed.place(m.positions[v])) - corner;
            seen[v].head<2>() *= 2;
        }
        bands.resize(static_cast<std::size_t>((frame.height + band_height - 1) / band_height));
        const auto band_of = [&](double row) {
            const double band = std::floor(row / (2 * band_height));
            return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(bands.size() - 1)));
        };
        const bool hides_its_back = is_closed(m);
        for (std::size_t t = 0; t < m.triangles.size(); ++t) {
            if (hides_its_back && faces_away(t)) continue;
            const auto [low, high] = std::minmax({point(t, 0).y(), point(t, 1).y(), point(t, 2).y()});
            for (std::size_t band = band_of(low - 2); band <= band_of(high + 2); ++band)
                bands[band].push_back(static_cast<std::int32_t>(t));
        }
    }

    /// Whether the corners, counter-clockwise from outside, run the other way round as seen (rows run downward).
    [[nodiscard]] bool faces_away(std::size_t t) const {
        const Vec3 &a = point(t, 0), &b = point(t, 1), &c = point(t, 2);
        return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y()) > 0;
    }

    [[nodiscard]] const Vec3& point(std::size_t t, std::size_t i) const {
        return seen[static_cast<std::size_t>(mesh.triangles[t][i])];
    }
};

/// The rows of pixels [top, top + height) of the frame.
class Band {
public:
    Band(const Scene& scene, const Frame& frame)
        : scene_(scene), frame_(frame), samples_(2 * frame.width + 2, 2 * band_height + 2) {
        split_.resize(static_cast<std::size_t>(samples_.columns()) * static_cast<std::size_t>(samples_.rows()));
    }

    void draw(Canvas& canvas, std::size_t band) {
        if (scene_.bands[band].empty()) return;
        see(band);
        find_splits();
        const int top = static_cast<int>(band) * band_height;
        for (int y = 0; y < std::min(band_height, frame_.height - top); ++y) paint_row(canvas, top, y);
    }

private:
    void see(std::size_t band) {
        samples_.clear();
        facets_.clear();
        double low = samples_.columns(), high = 0;
        const Vec3 shift(1, 1 - 2.0 * band_height * static_cast<double>(band), 0);  // room for one sample more
        for (const std::int32_t triangle : scene_.bands[band]) {
            const auto t = static_cast<std::size_t>(triangle);
            std::array<Vec3, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = scene_.point(t, i) + shift;
                low = std::min(low, corners[i].x());
                high = std::max(high, corners[i].x());
            }
            Facet facet;
            facet.plane = samples_.add(corners, static_cast<std::int32_t>(facets_.size()));
            facet.part = scene_.annotation.part_of_triangle[t];
            const Color color =
                facet.part < 0 ? unlabelled_color : scene_.part_colors[static_cast<std::size_t>(facet.part)];
            Vec3 towards(facet.plane.along_x * scene_.scale, facet.plane.along_y * scene_.scale, -1);
            facet.color = shaded(color, scene_.lamps.on(towards.normalized()));
            facets_.push_back(facet);
        }
        first_column_ = std::clamp(static_cast<int>(low) - 2, 0, samples_.columns());
        last_column_ = std::clamp(static_cast<int>(high) + 2, 0, samples_.columns() - 1);
    }

    /// Whether something separates the facet p, seen at (x, y), from q, seen at (u, v).
    [[nodiscard]] bool is_split(std::int32_t p, int x, int y, std::int32_t q, int u, int v) const {
        if (p < 0 || q < 0) return true;
        const Facet& first = facets_[static_cast<std::size_t>(p)];
        const Facet& second = facets_[static_cast<std::size_t>(q)];
        if (first.part != second.part) return true;
        if (std::max(first.plane.far, second.plane.far) - std::min(first.plane.near, second.plane.near) <= depth_jump)
            return false;
        const double here = first.plane.at(x, y, 0), there = second.plane.at(u, v, 0);
        if (std::abs(here - there) <= depth_jump) return false;
        const double forth = std::abs(first.plane.at(u, v, 0.5) - there);
        const double back = std::abs(second.plane.at(x, y, 0.5) - here);
        return std::min(forth, back) > depth_jump;
    }

    /// Marks the samples on both sides of every split.
    void find_splits() {
        std::ranges::fill(split_, std::uint8_t{0});
        for (int y = 0; y < samples_.rows(); ++y) {
            const std::int32_t* here = samples_.row(y);
            const std::int32_t* below = y + 1 < samples_.rows() ? samples_.row(y + 1) : here;
            int x = first_column_;
            for (; x + block < last_column_; x += block)
                if (has_borders(here + x, below + x)) find_splits(here, below, x, x + block, y);
            find_splits(here, below, x, last_column_ + 1, y);
        }
    }

    /// Whether any of `block` samples differs from the next one or from the one below.
    [[nodiscard]] static bool has_borders(const std::int32_t* here, const std::int32_t* below) {
        std::int32_t differences = 0;
        for (int i = 0; i < block; ++i) differences |= (here[i] ^ here[i + 1]) | (here[i] ^ below[i]);
        return differences != 0;
    }

    void find_splits(const std::int32_t* here, const std::int32_t* below, int begin, int end, int y) {
        const int columns = samples_.columns();
        std::uint8_t* split = split_.data() + static_cast<std::ptrdiff_t>(y) * columns;
        for (int x = begin; x < end; ++x) {
            if (x < last_column_ && here[x] != here[x + 1] && is_split(here[x], x, y, here[x + 1], x + 1, y))
                split[x] = split[x + 1] = 1;
            if (here[x] != below[x] && is_split(here[x], x, y, below[x], x, y + 1)) split[x] = split[x + columns] = 1;
        }
    }

    void paint_row(Canvas& canvas, int top, int y) const {
        const std::size_t columns = static_cast<std::size_t>(samples_.columns());
        const std::int32_t *upper = samples_.row(2 * y + 1) + 1, *lower = samples_.row(2 * y + 2) + 1;
        const std::uint8_t* split = split_.data() + static_cast<std::size_t>(2 * y + 1) * columns + 1;
        const int last = std::min(frame_.width - 1, (last_column_ - 1) / 2);
        const auto paint = [&](int x, Color color) { canvas.set(frame_.left + x, frame_.top + top + y, color); };
        std::int32_t before = -1;  // what the last plain pixel showed
        Color color = white;
        for (int x = std::max(first_column_ - 1, 0) / 2; x <= last; ++x) {
            const std::int32_t *above = upper + 2 * x, *under = lower + 2 * x;
            const std::uint8_t* at = split + static_cast<std::ptrdiff_t>(2) * x;
            const std::int32_t front = above[0];
            const bool is_mixed = ((front ^ above[1]) | (front ^ under[0]) | (front ^ under[1])) != 0;
            if (is_mixed || (at[0] | at[1] | at[columns] | at[columns + 1]) != 0) {
                paint(x, mean({front, above[1], under[0], under[1]}, {at[0], at[1], at[columns], at[columns + 1]}));
                continue;
            }
            if (front < 0) continue;
            if (front != before) color = facets_[static_cast<std::size_t>(before = front)].color;
            paint(x, color);
        }
    }

    /// The colour of four samples. Mixtures keep the upper half of their bits, so that a picture has few colours.
    [[nodiscard]] Color mean(const std::array<std::int32_t, 4>& fronts,
                             const std::array<std::uint8_t, 4>& splits) const {
        const auto color_at = [&](std::size_t i) {
            return splits[i] != 0 ? ink : fronts[i] < 0 ? white : facets_[static_cast<std::size_t>(fronts[i])].color;
        };
        const Color first = color_at(0);
        std::array<unsigned, 3> sum{first[0], first[1], first[2]};
        bool is_mixed = false;
        for (std::size_t i = 1; i < 4; ++i) {
            const Color color = color_at(i);
            is_mixed = is_mixed || color != first;
            for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += color[channel];
        }
        if (!is_mixed) return first;
        Color mixed;
        for (std::size_t channel = 0; channel < 3; ++channel)
            mixed[channel] = static_cast<std::uint8_t>((sum[channel] / 4 & 0xf0U) | 8U);
        return mixed;
    }

    const Scene& scene_;
    const Frame frame_;
    Samples samples_;                         ///< the band's, and one more on each side
    std::vector<Facet> facets_;               ///< the band's triangles
    std::vector<std::uint8_t> split_;         ///< samples beside a split
    int first_column_ = 0, last_column_ = 0;  ///< of samples that may show something
};

}  // namespace

void draw_object(Canvas& canvas, const Frame& frame, const TriangleMesh& mesh, const Annotation& annotation,
                 const Annotation& viewed, const Vec3& up, const PreviewOptions& options) {
    if (mesh.triangles.empty() || frame.width < 4 || frame.height < 4) return;
    const PlacedMesh placed(mesh);
    const Frame inner{frame.left + 1, frame.top + 1, frame.width - 2, frame.height - 2};  // room for the line around it
    const Camera camera = choose_view(placed, viewed, up, inner, options.threads);
    const Scene scene(mesh, placed, annotation, camera, up.stableNormalized(), frame);
    for_each_range(
        scene.bands.size(), options.threads,
        [&](std::size_t begin, std::size_t end) {
            Band band(scene, frame);
            for (std::size_t i = begin; i < end; ++i) band.draw(canvas, i);
        },
        4);
}

}  // namespace partonomy
