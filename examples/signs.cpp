#include "examples/signs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "examples/solid.h"

// A sign is a plate that stands upright and looks along -y, with a grey back and rim, in front of a pole. Its front is
// one field, or an inner field within an outer one. Both outlines have their points at the same angles around the
// middle of the plate, so that quads fill the ring between them.

namespace partonomy {
namespace {

constexpr double plate_radius = 0.3, plate_thickness = 0.06, middle_height = 0.9;
constexpr std::array<std::uint8_t, 3> grey{128, 130, 133}, white{250, 250, 250}, red{200, 16, 30}, blue{0, 70, 170},
    yellow{250, 210, 0}, green{0, 140, 60}, purple{130, 0, 140}, orange{240, 120, 0};

/// A convex outline: radius by angle, and the angles of its corners.
struct Outline {
    std::function<double(double)> radius;
    std::vector<double> corners;
};

Outline disc(double radius) {
    return {[radius](double) { return radius; }, {}};
}

Outline rectangle(double half_width, double half_height) {
    const double corner = std::atan2(half_height, half_width);
    const double pi = std::numbers::pi;
    return {[=](double angle) {
                return std::min(half_width / std::max(1e-12, std::abs(std::cos(angle))),
                                half_height / std::max(1e-12, std::abs(std::sin(angle))));
            },
            {corner, pi - corner, -corner, corner - pi}};
}

Outline polygon(int sides, double radius, double first_corner) {
    const double step = 2 * std::numbers::pi / sides;
    std::vector<double> corners;
    for (int i = 0; i < sides; ++i) corners.push_back(std::remainder(first_corner + i * step, 2 * std::numbers::pi));
    return {[=](double angle) {
                const double from_corner = angle - first_corner - step * std::floor((angle - first_corner) / step);
                return radius * std::cos(step / 2) / std::cos(from_corner - step / 2);
            },
            corners};
}

struct Field {
    Outline outline;
    std::string label;
    std::array<std::uint8_t, 3> rgb;
};

class Sign {
public:
    Sign(const Field& outer, const Field* inner, std::array<std::uint8_t, 3> pole_rgb, const std::string& pole_label) {
        std::vector<double> angles = outer.outline.corners;
        if (inner) angles.insert(angles.end(), inner->outline.corners.begin(), inner->outline.corners.end());
        for (int i = 0; i < 24; ++i) angles.push_back(std::remainder(i * std::numbers::pi / 12, 2 * std::numbers::pi));
        std::ranges::sort(angles);
        const auto same = [](double a, double b) { return b - a < 1e-3; };
        angles.erase(std::unique(angles.begin(), angles.end(), same), angles.end());
        const std::vector<Solid::Vertex> front = ring(outer.outline, angles, -plate_thickness),
                                         back = ring(outer.outline, angles, 0);
        const std::size_t n = angles.size();
        begin(outer.label, outer.rgb);
        if (inner) {
            const std::vector<Solid::Vertex> inside = ring(inner->outline, angles, -plate_thickness);
            for (std::size_t i = 0; i < n; ++i)
                solid_.face({front[i], front[(i + 1) % n], inside[(i + 1) % n], inside[i]});
            begin(inner->label, inner->rgb);
            solid_.face(inside);
        } else {
            solid_.face(front);
        }
        begin("Back", grey);
        solid_.face(back, true);
        for (std::size_t i = 0; i < n; ++i) solid_.face({front[i], back[i], back[(i + 1) % n], front[(i + 1) % n]});
        begin(pole_label, pole_rgb);
        pole();
    }

    PaintedObject finish(const std::string& name, const std::string& object_class, const std::string& wrong) && {
        begin("", grey);
        PaintedObject result;
        result.object = std::move(solid_).finish(name, object_class, wrong);
        --result.object.part_count;  // the last one has no faces
        result.paints = std::move(paints_);
        result.paints.pop_back();
        for (const int part : result.object.parts) result.paint_of.push_back(part);
        return result;
    }

private:
    void begin(const std::string& label, const std::array<std::uint8_t, 3>& rgb) {
        solid_.begin_part(label);
        paints_.push_back({"paint" + std::to_string(paints_.size()), rgb, 0, 0.8, std::nullopt});
    }

    std::vector<Solid::Vertex> ring(const Outline& outline, const std::vector<double>& angles, double y) {
        std::vector<Solid::Vertex> points;
        for (const double angle : angles) {
            const double r = outline.radius(angle);
            points.push_back(solid_.at(r * std::cos(angle), y, middle_height + r * std::sin(angle)));
        }
        return points;
    }

    void pole() {
        constexpr double half = 0.03, gap = 0.004;
        const auto corner = [&](int i, double z) {
            return solid_.at(i == 1 || i == 2 ? half : -half, i >= 2 ? gap + 2 * half : gap, z);
        };
        const std::vector<Solid::Vertex> base{corner(0, 0), corner(1, 0), corner(2, 0), corner(3, 0)};
        solid_.face(base, true);
        solid_.prism(base, middle_height + 0.1);
    }

    Solid solid_;
    std::vector<Paint> paints_;
};

PaintedObject sign(const std::string& name, const std::string& object_class, const Field& outer,
                   const Field* inner = nullptr, const std::string& wrong = {},
                   std::array<std::uint8_t, 3> pole = grey) {
    return Sign(outer, inner, pole, "Pole").finish(name, object_class, wrong);
}

/// A board across two poles, with slanting stripes or a chessboard on its front as an image.
PaintedObject barrier(const std::string& name, const std::string& object_class, const std::string& label,
                      const Image& image) {
    Solid solid;
    PaintedObject result;
    const auto box = [&](const Vec3& low, const Vec3& high) {
        const std::vector<Solid::Vertex> base{solid.at(low.x(), low.y(), low.z()), solid.at(high.x(), low.y(), low.z()),
                                              solid.at(high.x(), high.y(), low.z()),
                                              solid.at(low.x(), high.y(), low.z())};
        solid.face(base, true);
        solid.prism(base, high.z());
    };
    solid.begin_part(label);
    box({-0.6, -0.05, 0.5}, {0.6, 0, 0.8});
    solid.begin_part("Pole");
    box({-0.5, 0.004, 0}, {-0.44, 0.064, 0.75});
    solid.begin_part("Pole");
    box({0.44, 0.004, 0}, {0.5, 0.064, 0.75});
    result.object = std::move(solid).finish(name, object_class);
    result.paints = {{"warning", white, 0, 0.8, image}, {"steel", grey, 0, 0.8, std::nullopt}};
    const TriangleMesh& mesh = result.object.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        result.paint_of.push_back(result.object.parts[t] == 0 ? 0 : 1);
        auto& points = result.points.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][i])];
            points[i] = {static_cast<float>((p.x() + 0.6) / 0.3), static_cast<float>((0.8 - p.z()) / 0.3)};
        }
    }
    return result;
}

const Outline bar = rectangle(0.22, 0.05), upright_bar = rectangle(0.05, 0.2), square = rectangle(0.26, 0.26);

}  // namespace

std::vector<PaintedObject> signs() {
    const Field red_disc{disc(plate_radius), "RedField", red}, blue_disc{disc(plate_radius), "BlueField", blue};
    const Field white_bar{bar, "WhiteBar", white}, white_arrow{upright_bar, "WhiteBar", white};
    const Field white_disc{disc(0.2), "WhiteField", white}, blue_inside{disc(0.2), "BlueField", blue};
    const Field octagon{polygon(8, plate_radius, std::numbers::pi / 8), "RedField", red};
    const Field red_triangle{polygon(3, 0.36, std::numbers::pi / 2), "RedField", red};
    const Field yellow_triangle{polygon(3, 0.22, std::numbers::pi / 2), "YellowField", yellow};
    const Field blue_square{square, "BlueField", blue}, white_square{rectangle(0.16, 0.16), "WhiteField", white};
    const Field white_frame{square, "WhiteField", white}, yellow_square{rectangle(0.2, 0.2), "YellowField", yellow};
    const auto is_red = [](int x, int y) { return (x + y) / 16 % 2 == 0 ? red : white; };
    return {sign("no-entry", "NoEntrySign", red_disc, &white_bar),
            sign("one-way", "MandatorySign", blue_disc, &white_arrow),
            sign("no-vehicles", "ProhibitionSign", red_disc, &white_disc),
            sign("no-parking", "NoParkingSign", red_disc, &blue_inside),
            sign("stop", "StopSign", octagon),
            sign("danger", "WarningSign", red_triangle, &yellow_triangle),
            sign("crossing", "InformationSign", blue_square, &white_square),
            sign("priority", "PrioritySign", white_frame, &yellow_square),
            barrier("barrier", "Barrier", "StripedPanel", make_image(32, 32, is_red))};
}

std::vector<PaintedObject> wrong_signs() {
    const Field green_disc{disc(plate_radius), "", green}, purple_square{square, "", purple},
        orange_disc{disc(0.2), "", orange};
    const Field red_disc{disc(plate_radius), "RedField", red}, blue_disc{disc(plate_radius), "BlueField", blue},
        yellow_disc{disc(plate_radius), "YellowField", yellow};
    const Field white_bar{bar, "WhiteBar", white}, white_square{rectangle(0.16, 0.16), "WhiteField", white},
        blue_inside{disc(0.2), "BlueField", blue};
    return {sign("green-no-entry", "", green_disc, &white_bar, "StrangeColour"),
            sign("purple-crossing", "", purple_square, &white_square, "StrangeColour"),
            sign("orange-inside", "StopSign", red_disc, &orange_disc, "StrangeColour"),
            sign("green-pole", "NoEntrySign", red_disc, &white_bar, "ColouredPole", green),
            sign("yellow-and-blue", "", yellow_disc, &blue_inside),
            sign("blank-yellow", "", yellow_disc)};
}

}  // namespace partonomy
