// One ray a pixel or less, then four more in the pixels that need them.
//
// A block of 8 x 8 pixels is seen by 16 rays first, and by the other 48 only where these show more than one smooth
// surface: the inside of parts and the background cost a quarter. What is thinner than two pixels may go unseen between them.
//
// The first pass knows the triangle behind each pixel's middle. Two pixels beside each other are split when they show
// different parts, or when one surface, continued as a plane, misses the other by more than 2 % of the object: there
// runs a dark line. They also differ when shading jumps (a sharp edge within a part). Pixels on either side of a split
// or a jump are seen again through 2 x 2 rays; on that finer grid the same question is asked again, samples beside a
// split become line, and the mean of the four is the pixel: smooth edges and smooth lines for the price of a fifth more
// rays.
//
// Embree answers which triangle is hit and nothing else; depth and shade come from the triangle's own plane in double
// precision, so the picture does not depend on the instructions that the processor offers.

#include "report/draw_object.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "report/picture_rays.h"
#include "shape/ranges.h"

namespace partonomy {
namespace {

constexpr Color white{255, 255, 255}, ink{38, 38, 44};
constexpr double depth_jump = 0.02;
constexpr int shade_jump = 10;
constexpr int block = 8;  // pixels
constexpr float nudge_x = 0.0137F, nudge_y = 0.0071F;  // keeps rays off the edges of symmetric objects

/// A triangle as the camera sees it.
struct Facet {
    Color color = white;
    std::int32_t part = -1;
    double slope_x = 0, slope_y = 0, depth = 0;  ///< depth at pixel (x, y): depth + slope_x x + slope_y y
    double near = 0, far = 0;
};

Color shaded(Color color, double light) {
    for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(std::clamp(static_cast<int>(channel * light + 0.5), 0, 255));
    return color;
}

/// Light from above and from the viewer's left shoulder, and some from everywhere.
double light_on(const Vec3& normal, const Camera& camera, const Vec3& up) {
    const Vec3 lamp = (-camera.into - 0.55 * camera.right - 0.25 * camera.down).normalized();
    return 0.54 + 0.40 * std::max(0.0, normal.dot(lamp)) + 0.16 * std::max(0.0, normal.dot(up));
}

std::vector<Facet> make_facets(const PictureRays& rays, const TriangleMesh& mesh, const Annotation& annotation,
                               const Camera& camera, const Vec3& up) {
    std::vector<Facet> facets(mesh.triangles.size());
    for (std::size_t t = 0; t < facets.size(); ++t) {
        std::array<Vec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = rays.place(mesh.positions[static_cast<std::size_t>(mesh.triangles[t][i])]);
        Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
        if (normal.dot(camera.into) > 0) normal = -normal;  // a sheet seen from behind
        Facet& facet = facets[t];
        facet.part = annotation.part_of_triangle[t];
        const Color color =
            facet.part < 0 ? unlabelled_color : color_of(annotation.parts[static_cast<std::size_t>(facet.part)]);
        facet.color = shaded(color, light_on(normal, camera, up));
        std::array<double, 3> depths{};
        for (std::size_t i = 0; i < 3; ++i) depths[i] = corners[i].dot(camera.into);
        facet.near = *std::ranges::min_element(depths);
        facet.far = *std::ranges::max_element(depths);
        const double across = normal.dot(camera.into);
        if (std::abs(across) < 1e-9) {
            facet.depth = facet.near;
            continue;
        }
        facet.slope_x = -normal.dot(camera.right) / across / camera.scale;
        facet.slope_y = -normal.dot(camera.down) / across / camera.scale;
        facet.depth =
            normal.dot(corners[0]) / across - facet.slope_x * camera.center_x - facet.slope_y * camera.center_y;
    }
    return facets;
}

enum class Border { none, crease, line };

class Drawing {
public:
    Drawing(Canvas& canvas, const Frame& frame, const std::vector<Facet>& facets)
        : canvas_(canvas), frame_(frame), facets_(facets), hits_(pixel_count(), -1), finer_(pixel_count(), -1) {}

    void draw(const PictureRays& rays, const Camera& camera, int threads) {
        const auto each = [&](std::size_t count, std::size_t grain, const auto& work) {
            for_each_range(
                count, threads,
                [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) work(static_cast<int>(i));
                },
                grain);
        };
        const auto rows = static_cast<std::size_t>(frame_.height);
        each((rows + block - 1) / block, 1, [&](int band) {
            for (int left = 0; left < frame_.width; left += block) cast_block(rays, camera, left, band * block);
        });
        find_borders();
        samples_.resize(borders_.size());
        each((borders_.size() + 3) / 4, 64,
             [&](int packet) { cast_finer(rays, camera, static_cast<std::size_t>(packet) * 4); });
        each(rows, block, [&](int y) { paint_row(y); });
    }

private:
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(frame_.width) * static_cast<std::size_t>(frame_.height);
    }
    [[nodiscard]] std::size_t at_pixel(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) + static_cast<std::size_t>(x);
    }

    /// Sees every other pixel of every other row first: where they show one smooth surface (or nothing), the rest does.
    void cast_block(const PictureRays& rays, const Camera& camera, int left, int top) {
        std::array<std::int32_t, static_cast<std::size_t>(block* block)> seen{};
        RayPacket packet;
        const auto cast_quarter = [&](int shift_x, int shift_y) {
            const auto pixel = [&](std::size_t i) {
                return std::pair(2 * static_cast<int>(i % 4) + shift_x, 2 * static_cast<int>(i / 4) + shift_y);
            };
            for (std::size_t i = 0; i < RayPacket::size; ++i) {
                const auto [x, y] = pixel(i);
                packet.x[i] = static_cast<float>(frame_.left + left + x) + 0.5F + nudge_x;
                packet.y[i] = static_cast<float>(frame_.top + top + y) + 0.5F + nudge_y;
            }
            rays.cast(camera, packet);
            for (std::size_t i = 0; i < RayPacket::size; ++i) {
                const auto [x, y] = pixel(i);
                seen[static_cast<std::size_t>(y * block + x)] = packet.triangle[i];
            }
        };
        const auto is_plain = [&] {
            for (std::size_t i = 1; i < RayPacket::size; ++i)
                if (border(packet.triangle[0], packet.x[0], packet.y[0], packet.triangle[i], packet.x[i],
                           packet.y[i]) != Border::none)
                    return false;
            return true;
        };
        cast_quarter(0, 0);
        if (is_plain()) {
            for (int y = 0; y < block; ++y)
                for (int x = 0; x < block; ++x)
                    seen[static_cast<std::size_t>(y * block + x)] =
                        seen[static_cast<std::size_t>((y & ~1) * block + (x & ~1))];
        } else {
            cast_quarter(1, 0);
            cast_quarter(0, 1);
            cast_quarter(1, 1);
        }
        for (int y = 0; y < std::min(block, frame_.height - top); ++y)
            for (int x = 0; x < std::min(block, frame_.width - left); ++x)
                hits_[at_pixel(left + x, top + y)] = seen[static_cast<std::size_t>(y * block + x)];
    }

    /// Depth of facet p at a place in pixels of the canvas, held within the facet's own range widened by `slack`.
    [[nodiscard]] static double depth_at(const Facet& p, double x, double y, double slack) {
        return std::clamp(p.depth + p.slope_x * x + p.slope_y * y, p.near - slack, p.far + slack);
    }

    /// What separates the triangles p, seen at (x, y), and q, seen at (u, v).
    [[nodiscard]] Border border(std::int32_t p, double x, double y, std::int32_t q, double u, double v) const {
        if (p == q) return Border::none;
        if (p < 0 || q < 0) return Border::line;
        const Facet& first = facets_[static_cast<std::size_t>(p)];
        const Facet& second = facets_[static_cast<std::size_t>(q)];
        if (first.part != second.part) return Border::line;
        const double here = depth_at(first, x, y, 0), there = depth_at(second, u, v, 0);
        if (std::abs(here - there) > depth_jump) {
            const double forth = std::abs(depth_at(first, u, v, 0.5) - there);
            const double back = std::abs(depth_at(second, x, y, 0.5) - here);
            if (std::min(forth, back) > depth_jump) return Border::line;
        }
        for (std::size_t i = 0; i < 3; ++i)
            if (std::abs(first.color[i] - second.color[i]) > shade_jump) return Border::crease;
        return Border::none;
    }

    void find_borders() {
        std::vector<std::uint8_t> wanted(pixel_count(), 0);
        const auto compare = [&](int x, int y, int u, int v) {
            const std::size_t p = at_pixel(x, y), q = at_pixel(u, v);
            if (hits_[p] == hits_[q]) return;
            if (border(hits_[p], frame_.left + x + 0.5, frame_.top + y + 0.5, hits_[q], frame_.left + u + 0.5,
                       frame_.top + v + 0.5) == Border::none)
                return;
            wanted[p] = wanted[q] = 1;
        };
        for (int y = 0; y < frame_.height; ++y)
            for (int x = 0; x < frame_.width; ++x) {
                if (x + 1 < frame_.width) compare(x, y, x + 1, y);
                if (y + 1 < frame_.height) compare(x, y, x, y + 1);
            }
        for (std::size_t p = 0; p < wanted.size(); ++p)
            if (wanted[p] != 0) {
                finer_[p] = static_cast<std::int32_t>(borders_.size());
                borders_.push_back(static_cast<std::int32_t>(p));
            }
    }

    void cast_finer(const PictureRays& rays, const Camera& camera, std::size_t first) {
        RayPacket packet;
        for (std::size_t i = 0; i < RayPacket::size; ++i) {
            const std::int32_t p = borders_[std::min(first + i / 4, borders_.size() - 1)];
            const float half_x = i % 2 == 0 ? 0.25F : 0.75F, half_y = i / 2 % 2 == 0 ? 0.25F : 0.75F;
            packet.x[i] = static_cast<float>(frame_.left + p % frame_.width) + half_x + nudge_x;
            packet.y[i] = static_cast<float>(frame_.top + p / frame_.width) + half_y + nudge_y;
        }
        rays.cast(camera, packet);
        for (std::size_t i = 0; i < RayPacket::size; ++i)
            if (first + i / 4 < borders_.size()) samples_[first + i / 4][i % 4] = packet.triangle[i];
    }

    /// The triangle at a place of the grid with twice the resolution.
    [[nodiscard]] std::int32_t fine_hit(int x, int y) const {
        if (x < 0 || y < 0 || x >= 2 * frame_.width || y >= 2 * frame_.height) return -1;
        const std::size_t p = at_pixel(x / 2, y / 2);
        if (finer_[p] < 0) return hits_[p];
        return samples_[static_cast<std::size_t>(finer_[p])][static_cast<std::size_t>(x % 2 + y % 2 * 2)];
    }

    /// The mean of the pixel's four samples; those beside a split, in all eight directions, are ink.
    [[nodiscard]] Color fine_color(int x, int y) const {
        std::array<std::array<std::int32_t, 4>, 4> hits{};  // [row][column], the pixel's own four in the middle
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                hits[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = fine_hit(2 * x + i - 1, 2 * y + j - 1);
        const auto is_split = [&](std::size_t row, std::size_t column) {
            const std::int32_t here = hits[row][column];
            const auto place_x = [&](std::size_t i) { return frame_.left + x + static_cast<double>(i) / 2 - 0.25; };
            const auto place_y = [&](std::size_t j) { return frame_.top + y + static_cast<double>(j) / 2 - 0.25; };
            for (std::size_t j = row - 1; j <= row + 1; ++j)
                for (std::size_t i = column - 1; i <= column + 1; ++i)
                    if (hits[j][i] != here &&
                        border(here, place_x(column), place_y(row), hits[j][i], place_x(i), place_y(j)) == Border::line)
                        return true;
            return false;
        };
        std::array<int, 3> sum{2, 2, 2};
        for (std::size_t row = 1; row <= 2; ++row)
            for (std::size_t column = 1; column <= 2; ++column) {
                const Color color = is_split(row, column) ? ink : color_of_hit(hits[row][column]);
                for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += color[channel];
            }
        return {static_cast<std::uint8_t>(sum[0] / 4), static_cast<std::uint8_t>(sum[1] / 4),
                static_cast<std::uint8_t>(sum[2] / 4)};
    }

    [[nodiscard]] Color color_of_hit(std::int32_t triangle) const {
        return triangle < 0 ? white : facets_[static_cast<std::size_t>(triangle)].color;
    }

    void paint_row(int y) {
        for (int x = 0; x < frame_.width; ++x) {
            const std::size_t p = at_pixel(x, y);
            if (finer_[p] >= 0)
                canvas_.set(frame_.left + x, frame_.top + y, fine_color(x, y));
            else if (hits_[p] >= 0)
                canvas_.set(frame_.left + x, frame_.top + y, color_of_hit(hits_[p]));
        }
    }

    Canvas& canvas_;
    const Frame frame_;
    const std::vector<Facet>& facets_;
    std::vector<std::int32_t> hits_;                    ///< triangle a pixel
    std::vector<std::int32_t> finer_;                   ///< index into samples_ a pixel, -1 where one ray is enough
    std::vector<std::int32_t> borders_;                 ///< pixels that have samples
    std::vector<std::array<std::int32_t, 4>> samples_;  ///< triangles of the 2 x 2 rays
};

}  // namespace

void draw_object(Canvas& canvas, const Frame& frame, const TriangleMesh& mesh, const Annotation& annotation,
                 const Vec3& up, const PreviewOptions& options) {
    if (mesh.triangles.empty() || frame.width < 4 || frame.height < 4) return;
    const PictureRays rays(mesh, options.tree);
    const Frame inner{frame.left + 1, frame.top + 1, frame.width - 2, frame.height - 2};  // room for the line around it
    const Camera camera = choose_view(rays, mesh, annotation, up, inner);
    const std::vector<Facet> facets = make_facets(rays, mesh, annotation, camera, up.stableNormalized());
    Drawing(canvas, frame, facets).draw(rays, camera, options.threads);
}

}  // namespace partonomy
