#include "algorithms/concept_shapes.h"

#include "shape/solids.h"

namespace partonomy {
namespace {

using namespace solids;
constexpr double pi = std::numbers::pi;
constexpr double step = 0.06;

/// Bends a sweep along z into an arc of `degrees`, towards x.
auto along_arc(double length, double degrees) {
    return [=](double t, const Eigen::Vector2d& p) -> Vec3 {
        const double angle = degrees * pi / 180, radius = length / angle, turn = t * angle;
        return {radius - (radius - p.x()) * std::cos(turn), p.y(), (radius - p.x()) * std::sin(turn)};
    };
}

/// Shrinks a sweep towards its top.
auto shrinking(double length, double to) {
    return [=](double t, const Eigen::Vector2d& p) -> Vec3 {
        const double share = 1 + t * (to - 1);
        return {share * p.x(), share * p.y(), t * length};
    };
}

TriangleMesh pipe(double outer, double inner, double length, double along) {
    return revolve(polygon({{inner, 0}, {outer, 0}, {outer, length}, {inner, length}}, along),
                   static_cast<int>(2 * pi * outer / along), false);
}

TriangleMesh cuboid(double x, double y, double z) { return sweep(rectangle(x, y, step), z, step); }

/// Points at equal steps along an open line of corners.
Outline line(const Outline& corners) {
    Outline points = polygon(corners, step);
    const double closing = (corners.front() - corners.back()).norm();
    points.resize(points.size() - std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(closing / step))) + 1);
    return points;
}

/// A profile from the axis back to the axis, turned about z.
TriangleMesh turned(const Outline& profile) { return revolve(profile, 72, true); }

/// The upper side of a hill, or of a hollow when it is turned inside out.
TriangleMesh hill(double height, bool is_hollow) {
    constexpr int count = 32;
    TriangleMesh mesh;
    const auto at = [](int i) { return 2.0 * i / count - 1; };
    for (int i = 0; i <= count; ++i)
        for (int j = 0; j <= count; ++j)
            mesh.positions.emplace_back(at(i), at(j), (is_hollow ? height : -height) * (at(i) * at(i) + at(j) * at(j)));
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const std::int32_t a = i * (count + 1) + j, b = a + count + 1;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    return finish(std::move(mesh));
}

/// The first, and others beside it.
TriangleMesh together(TriangleMesh first, const std::vector<TriangleMesh>& others) {
    for (const TriangleMesh& other : others) {
        const auto offset = static_cast<std::int32_t>(first.positions.size());
        first.positions.insert(first.positions.end(), other.positions.begin(), other.positions.end());
        for (const auto& [a, b, c] : other.triangles) first.triangles.push_back({a + offset, b + offset, c + offset});
    }
    return finish(std::move(first));
}

TriangleMesh shifted(TriangleMesh mesh, const Vec3& by) {
    return moved(std::move(mesh), [&](const Vec3& p) -> Vec3 { return p + by; });
}

TriangleMesh blob() {
    return moved(ball(0.6, step), [](const Vec3& p) -> Vec3 {
        return p * (1 + 0.25 * std::sin(5 * p.x() + 1) * std::cos(6 * p.y()) + 0.2 * std::sin(7 * p.z()));
    });
}

/// Half a ball of radius 1 on a plate so wide that half of the surface is flat.
Outline mushroom() {
    Outline profile = line({{0, 0}, {1.2, 0}, {1.2, 0.05}, {1, 0.05}});
    profile.pop_back();
    for (int i = 0; i <= 24; ++i)
        profile.emplace_back(i == 24 ? 0 : std::cos(pi * i / 48), 0.05 + std::sin(pi * i / 48));
    return profile;
}

/// A cone, 2 along its side, on such a plate.
Outline hat() {
    Outline profile = line({{0, 0}, {1.19, 0}, {1.19, 0.05}, {1, 0.05}, {0, 0.05 + std::sqrt(3.0)}});
    profile.back() = {0, 0.05 + std::sqrt(3.0)};
    return profile;
}

/// Around a point within, towards which sweep() shrinks it.
Outline half_disc(double radius, double along) {
    const int count = static_cast<int>(std::lround(pi * radius / along));
    Outline points = line({{-radius, -0.4 * radius}, {radius, -0.4 * radius}});
    for (int i = 1; i < count; ++i)
        points.emplace_back(radius * std::cos(pi * i / count), radius * (std::sin(pi * i / count) - 0.4));
    return points;
}

/// A ball with three different axes: no piece of it is a piece of a ball or a torus for long.
TriangleMesh egg(double s) {
    TriangleMesh mesh = ball(0.7, s);
    for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(1, 0.74, 0.56));
    return mesh;
}

}  // namespace

std::vector<KnownShape> shapes_by_form() {
    const double s = step;
    std::vector<KnownShape> all;
    const auto add = [&](const char* name, TriangleMesh mesh, std::vector<std::string> is,
                         std::vector<std::string> border = {}) {
        all.push_back({name, std::move(mesh), std::move(is), std::move(border)});
    };
    add("square stick", cuboid(0.5, 0.5, 3),
        {"Stick", "Vertical", "Elongated", "Angular", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric",
         "Convex", "Upright", "Rectangle"});
    add("flat stick", cuboid(0.7, 0.4, 3), {"Elongated", "Angular", "Even", "Straight", "Solid"});
    add("round stick", sweep(ellipse(0.3, 0.3, s), 3, s),
        {"Stick", "Vertical", "Elongated", "Round", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric",
         "Convex", "Upright", "Cylinder"});
    add("oval stick", sweep(ellipse(0.35, 0.22, s), 3, s), {"Round", "Even", "Straight"});
    add("three-sided stick", sweep(regular(3, 0.4, s), 3, s), {"Angular", "Even", "Straight", "Solid", "Rectangle"});
    add("tapered round stick", sweep(ellipse(0.35, 0.35, s), 3, s, shrinking(3, 0.35)),
        {"Round", "Tapered", "Straight", "Solid", "Cone"});
    add("tapered square stick", sweep(rectangle(0.6, 0.6, s), 3, s, shrinking(3, 0.4)),
        {"Angular", "Tapered", "Straight", "Solid"});
    add("bent round stick", sweep(ellipse(0.18, 0.18, s), 3, s, along_arc(3, 60)), {"Round", "Even", "Bent", "Solid"});
    add("bent square stick", sweep(rectangle(0.35, 0.35, s), 3, s, along_arc(3, 50)),
        {"Angular", "Even", "Bent", "Solid"});
    add("board", cuboid(2, 1.4, 0.2),
        {"Board", "Horizontal", "Compact", "Angular", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric",
         "Level", "Rectangle"});
    add("round board", sweep(ellipse(1, 1, s), 0.2, s),
        {"Board", "Horizontal", "Compact", "Round", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric",
         "Level", "Disc"});
    add("long board on edge", cuboid(0.2, 3, 0.9), {"Board", "Vertical", "Elongated", "Upright"});
    add("bent board", sweep(rectangle(0.15, 1.5, s), 2, s, along_arc(2, 80)), {"Bent", "Even", "MirrorSymmetric"});
    add("arch", sweep(rectangle(0.25, 0.15, s), 2.75, s, along_arc(2.75, 180)), {"Board", "Bent", "MirrorSymmetric"});
    add("wide arch", sweep(rectangle(0.5, 0.15, s), 1.75, s, along_arc(1.75, 100)),
        {"Board", "Bent", "MirrorSymmetric"});
    add("deep arch", sweep(rectangle(0.2, 1, s), 2.8, s, along_arc(2.8, 180)), {"Bent"});
    add("half disc", sweep(half_disc(1, s), 0.15, s), {"Board", "Straight", "MirrorSymmetric"});
    add("board that narrows", sweep(polygon({{-1, -0.8}, {1, -0.25}, {1, 0.25}, {-1, 0.8}}, s), 0.2, s),
        {"Board", "Tapered", "Straight", "Solid", "MirrorSymmetric", "TurnAsymmetric", "Level", "Flat"});
    add("lopsided board", sweep(polygon({{-0.9, -0.6}, {1.1, -0.6}, {-0.9, 0.9}}, s), 0.25, s),
        {"Angular", "Straight", "Asymmetric", "TurnAsymmetric", "Flat"});
    add("slanting board", sweep(polygon({{-1, -0.5}, {0.6, -0.5}, {1, 0.5}, {-0.6, 0.5}}, s), 0.25, s),
        {"Straight", "Asymmetric", "TurnSymmetric"});
    add("cube", cuboid(1, 1, 1),
        {"Cube", "Compact", "Angular", "Even", "Straight", "Solid", "MirrorSymmetric", "Convex", "Rectangle"});
    add("ball", ball(0.6, s),
        {"Cube", "Compact", "Round", "Even", "Straight", "Solid", "MirrorSymmetric", "TurnSymmetric", "Convex",
         "Sphere"});
    add("ring", torus(0.8, 0.25, s), {"Round", "Even", "Solid", "MirrorSymmetric", "TurnSymmetric", "Torus"});
    add("pipe", pipe(0.5, 0.42, 2, 0.04),
        {"Round", "Even", "Straight", "Hollow", "MirrorSymmetric", "TurnSymmetric", "Cylinder"});
    add("blob", blob(), {"Freeform", "Solid"});
    add("cone as wide as high", sweep(ellipse(0.6, 0.6, s), 1.2, s, shrinking(1.2, 0.05)),
        {"Cube", "Cone", "Round", "Tapered", "Straight", "MirrorSymmetric", "TurnSymmetric"});
    add("round stick that narrows slowly", sweep(ellipse(0.2, 0.2, s), 3, s, shrinking(3, 0.5)),
        {"Stick", "Cone", "Round", "Tapered", "Straight", "Solid"});
    add("six-sided stick", sweep(regular(6, 0.3, s), 2, s), {"Stick", "Even", "Straight", "Solid", "Rectangle"});
    add("blunt cone", sweep(ellipse(0.6, 0.6, s), 1.5, s, shrinking(1.5, 1.0 / 3)),
        {"Cone", "Round", "Tapered", "Straight", "Solid"});
    add("slender cone", sweep(ellipse(0.25, 0.25, s), 3, s, shrinking(3, 0.1)),
        {"Stick", "Cone", "Round", "Tapered", "Straight"});
    add("coarse round stick", sweep(regular(16, 0.3, 1), 2, 2), {"Stick", "Round", "Even", "Straight", "Cylinder"});
    // Coarse meshes: where noise is smoothed away, edges of a few triangles go with it.
    add("coarse square stick", sweep(rectangle(0.5, 0.5, 0.17), 3, 0.17),
        {"Stick", "Vertical", "Angular", "Even", "Straight", "Solid", "Convex"});
    add("very coarse square stick", sweep(rectangle(0.5, 0.5, 0.25), 4, 0.25),
        {"Stick", "Angular", "Even", "Straight"});
    add("coarse cube", sweep(rectangle(1, 1, 0.25), 1, 0.25),
        {"Cube", "Angular", "Even", "Straight", "Solid", "Convex"});
    add("coarse board", sweep(rectangle(2, 1.4, 0.2), 0.2, 0.2),
        {"Board", "Horizontal", "Angular", "Even", "Straight", "Solid"});
    add("thin board with a narrow rim", sweep(rectangle(1.2, 0.9, 0.05), 0.06, 0.06),
        {"Board", "Horizontal", "Angular"});
    add("thin disc with a narrow rim", sweep(ellipse(0.6, 0.6, 0.05), 0.05, 0.05), {"Board", "Horizontal", "Round"});
    add("coarse ring", torus(0.8, 0.25, 0.12), {"Round", "Even", "Solid"});
    add("egg", egg(s), {"Cube", "Freeform", "Round", "Even", "Straight", "Convex"});
    add("slab on edge, tilted", tilted(sweep(rectangle(0.2, 1.2, s), 1.6, s), 45), {"Oblique", "Solid", "Straight"});
    add("leaning stick", tilted(cuboid(0.3, 0.3, 2.5), 35), {"Stick", "Oblique", "Straight"});
    add("stick that hardly leans", tilted(cuboid(0.3, 0.3, 2.5), 8), {"Stick", "Vertical", "Upright"});
    add("lying stick", tilted(cuboid(0.3, 0.3, 2.5), 90), {"Stick", "Horizontal", "Level"});
    add("hill", hill(0.3, false), {"Convex"});
    add("hollow", hill(0.3, true), {"Concave"});
    add("sheet", hill(0, false), {"Plane", "Rectangle", "Level"});

    add("block of 2 by 1 by 1", cuboid(1, 1, 2), {}, {"Stick", "Cube"});
    add("block of 2 by 2 by 1", cuboid(2, 2, 1), {}, {"Board", "Cube"});
    add("block of 4 by 2 by 1", cuboid(2, 1, 4), {}, {"Board", "Stick"});
    add("board, not quite long", cuboid(1.75, 1, 0.2), {"Board"}, {"Compact", "Elongated"});
    add("stick at 45 degrees", tilted(cuboid(0.3, 0.3, 2.5), 45), {"Stick", "Oblique"}, {"Horizontal", "Vertical"});
    add("stick at 15 degrees", tilted(cuboid(0.3, 0.3, 2.5), 75), {"Horizontal"}, {"Level", "Oblique"});
    add("stick at 75 degrees", tilted(cuboid(0.3, 0.3, 2.5), 15), {"Vertical"}, {"Upright", "Oblique"});
    add("stick that narrows a little", sweep(rectangle(0.5, 0.5, s), 3, s, shrinking(3, 0.72)), {},
        {"Even", "Tapered"});
    add("stick that bends a little", sweep(rectangle(0.3, 0.3, s), 3, s, along_arc(3, 30)), {}, {"Straight", "Bent"});
    add("five-sided stick", sweep(regular(5, 0.35, s), 3, s), {}, {"Round", "Angular"});
    add("thick pipe", pipe(0.5, 0.15, 2, 0.05), {}, {"Hollow", "Solid"});
    add("nearly a rectangle", sweep(polygon({{-1, -0.5}, {0.8, -0.5}, {1, 0.5}, {-0.8, 0.5}}, s), 0.25, s), {},
        {"MirrorSymmetric", "Asymmetric"});
    add("board that hardly narrows", sweep(polygon({{-1, -0.5}, {1, -0.43}, {1, 0.43}, {-1, 0.5}}, s), 0.25, s),
        {"MirrorSymmetric"}, {"TurnSymmetric", "TurnAsymmetric"});
    add("low hill", hill(0.0065, false), {"Level"}, {"Convex", "Plane"});
    add("shallow hollow", hill(0.0065, true), {"Level"}, {"Concave", "Plane"});
    add("board that narrows to 0.78", sweep(polygon({{-1, -0.6}, {1, -0.468}, {1, 0.468}, {-1, 0.6}}, s), 0.1, s), {},
        {"Rectangle", "Flat"});
    add("oval board", sweep(ellipse(1, 0.85, s), 0.1, s), {}, {"Disc", "Flat"});
    add("cylinder as high as wide is half of it", sweep(ellipse(0.8, 0.8, s), 0.8, s), {}, {"Cylinder", "Disc"});
    add("half ball on a plate", turned(mushroom()), {}, {"Sphere", "Disc"});
    add("cone on a plate", turned(hat()), {}, {"Cone", "Disc"});
    // Areas of the rings: 4 pi^2 0.8 0.2; of the discs, both sides and the rim, the same.
    add("ring and disc",
        together(torus(0.8, 0.2, s), {shifted(sweep(ellipse(0.98, 0.98, s), 0.05, s), {2.5, 0, -0.1})}), {},
        {"Torus", "Disc"});
    add("blob and disc", together(blob(), {shifted(sweep(ellipse(0.9, 0.9, s), 0.05, s), {2, 0, 0})}), {},
        {"Freeform", "Disc"});
    return all;
}

std::vector<KnownShape> shapes_by_place() {
    std::vector<KnownShape> all;
    // A block of a height of 0.2 between `low` and `low` + 0.2, beside a mast that reaches from 0 to 2.
    const auto beside_mast = [&](double low, std::vector<std::string> is, std::vector<std::string> border = {}) {
        const TriangleMesh block = shifted(cuboid(0.5, 0.4, 0.2), {1, 0, low}), mast = cuboid(0.1, 0.1, 2);
        all.push_back({"block from " + std::to_string(low), together(block, {mast}), std::move(is), std::move(border),
                       block.triangles.size()});
    };
    beside_mast(0, {"Down", "OnGround"});
    beside_mast(0.01, {"Down", "OnGround"});
    beside_mast(0.06, {"Down"}, {"OnGround", "OffGround"});
    beside_mast(0.16, {"OffGround"}, {"Down", "Central"});
    beside_mast(0.7, {"Central", "OffGround"});
    beside_mast(1, {"Central", "OffGround"});
    beside_mast(1.44, {"OffGround"}, {"Central", "Up"});
    beside_mast(1.8, {"Up", "OffGround"});
    // Le Corbusier's heights.
    const std::vector<int> heights{27, 43, 70, 86, 113, 140, 183, 226};
    const auto series = [](int height) { return "Series" + std::to_string(height); };
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const auto tall = [](double height) { return cuboid(0.3, 0.3, height); };
        const double height = heights[i] / 100.0;
        all.push_back({std::to_string(heights[i]) + " cm high",
                       tall(height),
                       {series(heights[i]), heights[i] == 27 ? "M27" : "M43"},
                       {}});
        if (i + 1 == heights.size()) continue;
        KnownShape between{"between " + series(heights[i]) + " and the next",
                           tall((height + heights[i + 1] / 100.0) / 2),
                           {},
                           {series(heights[i]), series(heights[i + 1])}};
        if (i == 0) between.border.insert(between.border.end(), {"M27", "M43"});
        all.push_back(std::move(between));
    }
    return all;
}

}  // namespace partonomy
