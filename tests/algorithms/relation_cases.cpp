#include "algorithms/relation_cases.h"

#include "shape/solids.h"

namespace partonomy {
namespace {

using solids::block;
using solids::Stage;
using Case = RelationCase;
using Truth = RelationTruth;

/// Boxes only.
Case boxes(const std::string& relation, Truth truth, std::vector<solids::Block> blocks, double tolerance = 0.02) {
    return {relation, truth,
            [blocks](Stage& stage, int steps) {
                for (const solids::Block& each : blocks) stage.add(each, steps);
            },
            tolerance};
}

solids::Block tilted(solids::Block box, double degrees, const Vec3& axis) {
    box.axes = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix() * box.axes;
    return box;
}

/// A plate under everything: the object's box is 2 by 1 by what stands on it, its diagonal near 2.45 with height 1.
solids::Block plate() { return block({0, 0, -0.1}, {2, 1, 0}); }
solids::Block mast() { return block({1.9, 0.9, 0}, {2, 1, 0.9}); }
/// Stands up at the back, so that the front is towards low y.
solids::Block back() { return block({0, 0.9, 0}, {2, 1, 0.9}); }

std::vector<Case> box_cases() {
    const double diagonal = std::sqrt(4.0 + 1 + 1);
    const auto cube = [](double x, double y, double z) { return block({x, y, z}, {x + 0.2, y + 0.2, z + 0.2}); };
    const auto gap_of = [&](double share) {
        return std::vector{cube(0.5, 0.4, 0.3), cube(0.7 + share * diagonal, 0.4, 0.3), plate(), mast()};
    };
    const auto stick = [](double x, double y, double z, double length = 0.6) {
        return block({x, y, z}, {x + length, y + 0.1, z + 0.1});
    };
    const auto board = [](double x, double y, double z, double thickness = 0.1) {
        return block({x, y, z}, {x + 0.6, y + 0.5, z + thickness});
    };
    const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
    std::vector<Case> all{
        boxes("Connected", Truth::yes, gap_of(0)),
        boxes("Connected", Truth::no, gap_of(0.05)),
        boxes("Connected", Truth::border, gap_of(0.01)),
        boxes("Close", Truth::yes, gap_of(0.02)),
        boxes("Close", Truth::no, gap_of(0.15)),
        boxes("Close", Truth::border, gap_of(0.075)),
        boxes("Far", Truth::yes, gap_of(0.3)),
        boxes("Far", Truth::no, gap_of(0.1)),
        boxes("Far", Truth::border, gap_of(0.2)),
        // Thin sticks side by side for two fifths of their length, the reach of a touch at both ends included.
        boxes("TouchesAlong", Truth::border,
              {block({0.5, 0.4, 0.3}, {1.1, 0.42, 0.32}),
               block({1.1 - (0.24 - 0.02 * diagonal), 0.42, 0.3}, {1.6, 0.44, 0.32}), plate(), mast()},
              0.2),
        // A board on edge along a stick; on its end.
        boxes("TouchesAlong", Truth::yes, {stick(0.5, 0.4, 0.1), board(0.5, 0.5, 0.1), plate(), mast()}),
        boxes("TouchesAlong", Truth::no,
              {block({0.5, 0.4, 0.1}, {0.6, 0.5, 0.9}), board(0.5, 0.4, 0), plate(), mast()}),
        boxes("TouchesAlong", Truth::no, {cube(0.5, 0.2, 0.3), cube(0.9, 0.6, 0.3), plate(), mast()}),
        boxes("UpFrom", Truth::yes, {cube(0.5, 0.4, 0.6), cube(0.5, 0.4, 0.1), plate(), mast()}),
        boxes("UpFrom", Truth::no, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.6), plate(), mast()}),
        boxes("UpFrom", Truth::no, {cube(0.1, 0.4, 0.6), cube(1.5, 0.4, 0.1), plate(), mast()}),
        boxes("UpFrom", Truth::border, {cube(0.5, 0.4, 0.2), cube(0.5, 0.4, 0.1), plate(), mast()}),
        boxes("Below", Truth::yes, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.6), plate(), mast()}),
        boxes("Below", Truth::no, {cube(0.5, 0.4, 0.6), cube(0.5, 0.4, 0.1), plate(), mast()}),
        boxes("Below", Truth::border, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.2), plate(), mast()}),
        boxes("Beside", Truth::yes, {cube(0.5, 0.4, 0.3), cube(0.8, 0.4, 0.3), plate(), mast()}),
        boxes("Beside", Truth::no, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.5), plate(), mast()}),
        boxes("Beside", Truth::no, {cube(0.1, 0.4, 0.1), cube(1.6, 0.4, 0.1), plate(), mast()}),
        boxes("Beside", Truth::border, {cube(0.5, 0.4, 0.1), cube(0.8, 0.4, 0.23), plate(), mast()}),
        boxes("InFrontOf", Truth::yes, {cube(0.5, 0.1, 0), cube(0.5, 0.6, 0), plate(), back()}),
        boxes("InFrontOf", Truth::no, {cube(0.5, 0.6, 0), cube(0.5, 0.1, 0), plate(), back()}),
        boxes("InFrontOf", Truth::border, {cube(0.5, 0.4, 0), cube(0.9, 0.5, 0), plate(), back()}),
        boxes("InFrontOf", Truth::unknown, {cube(0.9, 0.1, 0), cube(0.9, 0.7, 0), plate()}),
        boxes("Behind", Truth::yes, {cube(0.5, 0.6, 0), cube(0.5, 0.1, 0), plate(), back()}),
        boxes("Behind", Truth::no, {cube(0.5, 0.1, 0), cube(0.5, 0.6, 0), plate(), back()}),
        boxes("Behind", Truth::border, {cube(0.5, 0.5, 0), cube(0.9, 0.4, 0), plate(), back()}),
        boxes("Behind", Truth::unknown, {cube(0.9, 0.7, 0), cube(0.9, 0.1, 0), plate()}),
        boxes("Between", Truth::yes, {cube(0.8, 0.4, 0.3), cube(0.2, 0.4, 0.3), cube(1.4, 0.4, 0.3), plate(), mast()}),
        boxes("Between", Truth::no, {cube(0.2, 0.4, 0.3), cube(0.8, 0.4, 0.3), cube(1.4, 0.4, 0.3), plate(), mast()}),
        // A long body between wings that are swept back from its nose on; both lie behind its middle.
        boxes("Between", Truth::yes,
              {block({0.9, 0.05, 0.3}, {1.1, 0.95, 0.5}), tilted(block({0.2, 0.6, 0.35}, {0.85, 0.7, 0.4}), -25, z),
               tilted(block({1.15, 0.6, 0.35}, {1.8, 0.7, 0.4}), 25, z), plate(), mast()}),
        // Beside the row, though next to it; over it, as a beam over its posts; around both.
        boxes("Between", Truth::no,
              {block({0.2, 0.25, 0.3}, {1.6, 0.38, 0.5}), cube(0.4, 0.4, 0.3), cube(1.2, 0.4, 0.3), plate(), mast()}),
        boxes("Between", Truth::no,
              {block({0.4, 0.4, 0.5}, {1.4, 0.6, 0.6}), cube(0.4, 0.4, 0.3), cube(1.2, 0.4, 0.3), plate(), mast()}),
        boxes("Between", Truth::no,
              {block({0.2, 0.2, 0.1}, {1.6, 0.8, 0.7}), cube(0.4, 0.4, 0.3), cube(1.2, 0.4, 0.3), plate(), mast()}),
        // A slim post between large walls, and a large wall between slim posts.
        boxes("Between", Truth::yes,
              {block({0.9, 0.2, 0}, {0.95, 0.25, 0.6}), block({0.4, 0.1, 0}, {0.5, 0.9, 0.8}),
               block({1.4, 0.1, 0}, {1.5, 0.9, 0.8}), plate(), mast()}),
        boxes("Between", Truth::yes,
              {block({0.9, 0.1, 0}, {1, 0.9, 0.8}), block({0.5, 0.2, 0}, {0.55, 0.25, 0.6}),
               block({1.4, 0.2, 0}, {1.45, 0.25, 0.6}), plate(), mast()}),
        // 0.35 of its width is in the way.
        boxes("Between", Truth::border,
              {cube(0.9, 0.4, 0.3), cube(0.5, 0.53, 0.3), cube(1.4, 0.53, 0.3), plate(), mast()}),
        boxes("Inside", Truth::yes, {cube(0.5, 0.4, 0.3), block({0.3, 0.2, 0}, {1, 0.8, 0.8}), plate(), mast()}),
        boxes("Inside", Truth::no, {block({0.3, 0.2, 0}, {1, 0.8, 0.8}), cube(0.5, 0.4, 0.3), plate(), mast()}),
        boxes("Inside", Truth::no, {cube(0.5, 0.4, 0.3), block({0.6, 0.2, 0}, {1, 0.8, 0.8}), plate(), mast()}),
        // Four of the cube's sides end after 0.76 of their length, the fifth is inside: 0.8 of it.
        boxes("Inside", Truth::border,
              {block({0.5, 0.4, 0.3}, {0.7, 0.6, 0.5}), block({0.3, 0.2, 0}, {0.5 + 0.2 * 0.95, 0.8, 0.8}), plate(),
               mast()}),
        {"Around", Truth::yes,
         [cube](Stage& stage, int steps) {
             stage.add_ring({0.6, 0.5, 0.3}, 0.25, 0.05);
             for (const solids::Block& each : {cube(0.5, 0.4, 0.2), plate(), mast()}) stage.add(each, steps);
         }},
        {"Around", Truth::no,  // the other way round
         [cube](Stage& stage, int steps) {
             stage.add(cube(0.5, 0.4, 0.2), steps);
             stage.add_ring({0.6, 0.5, 0.3}, 0.25, 0.05);
             for (const solids::Block& each : {plate(), mast()}) stage.add(each, steps);
         }},
        {"Around", Truth::no,  // beside it
         [cube](Stage& stage, int steps) {
             stage.add_ring({1.3, 0.5, 0.3}, 0.25, 0.05);
             for (const solids::Block& each : {cube(0.5, 0.4, 0.2), plate(), mast()}) stage.add(each, steps);
         }},
        {"Around", Truth::no,  // above it
         [cube](Stage& stage, int steps) {
             stage.add_ring({0.6, 0.5, 0.7}, 0.25, 0.05);
             for (const solids::Block& each : {cube(0.5, 0.4, 0.2), plate(), mast()}) stage.add(each, steps);
         }},
        boxes("Parallel", Truth::yes, {board(0.2, 0.2, 0.1), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Parallel", Truth::yes, {board(0.2, 0.2, 0.1), stick(1, 0.2, 0.6), plate(), mast()}),
        boxes("Parallel", Truth::no, {board(0.2, 0.2, 0.1), tilted(board(1, 0.2, 0.3), 40, x), plate(), mast()}),
        boxes("Parallel", Truth::border, {stick(0.2, 0.2, 0.1), tilted(stick(1, 0.4, 0.3), 10, z), plate(), mast()}),
        boxes("Orthogonal", Truth::yes, {stick(0.2, 0.2, 0.1), tilted(stick(0.8, 0.4, 0.3), 90, z), plate(), mast()}),
        boxes("Orthogonal", Truth::yes, {block({0.5, 0.5, 0}, {0.6, 0.6, 0.8}), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Orthogonal", Truth::no, {board(0.2, 0.2, 0.1), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Orthogonal", Truth::border,
              {stick(0.2, 0.2, 0.1), tilted(stick(0.8, 0.4, 0.3), 80, z), plate(), mast()}),
        boxes("Coplanar", Truth::yes, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3), plate(), mast()}),
        boxes("Coplanar", Truth::yes, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3, 0.2), plate(), mast()}),
        boxes("Coplanar", Truth::no, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Coplanar", Truth::no, {stick(0.2, 0.2, 0.3), stick(1, 0.2, 0.3), plate(), mast()}),
        boxes("Coplanar", Truth::border, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3 + 0.02 * diagonal), plate(), mast()}),
        boxes("Collinear", Truth::yes, {stick(0.2, 0.4, 0.3), stick(1.1, 0.4, 0.3), plate(), mast()}),
        boxes("Collinear", Truth::no, {stick(0.2, 0.4, 0.3), stick(1.1, 0.6, 0.3), plate(), mast()}),
        boxes("Collinear", Truth::no, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3), plate(), mast()}),
        boxes("Collinear", Truth::border,
              {stick(0.2, 0.4, 0.3), stick(1.1, 0.4 + 0.02 * diagonal, 0.3), plate(), mast()}),
        boxes("Aligned", Truth::yes, {cube(0.2, 0.4, 0.3), stick(1.1, 0.45, 0.35), plate(), mast()}),
        boxes("Aligned", Truth::yes, {cube(0.2, 0.4, 0), cube(0.2, 0.4, 0.7), plate(), mast()}),
        boxes("Aligned", Truth::no, {cube(0.2, 0.4, 0.3), cube(0.8, 0.1, 0.3), plate(), mast()}),
        boxes("Aligned", Truth::border, {cube(0.2, 0.4, 0.3), cube(0.8, 0.4 + 0.02 * diagonal, 0.3), plate(), mast()}),
        boxes("Symmetric", Truth::yes,
              {tilted(stick(0.2, 0.4, 0.3), 30, z), tilted(stick(1.2, 0.4, 0.3), -30, z), plate(), mast()}),
        boxes("Symmetric", Truth::no,
              {tilted(stick(0.2, 0.4, 0.3), 30, z), tilted(stick(1.2, 0.4, 0.3), 30, z), plate(), mast()}),
        boxes("Symmetric", Truth::no, {cube(0.2, 0.4, 0.3), cube(1.4, 0.4, 0.3), plate(), mast()}),
        boxes("Symmetric", Truth::border,
              {cube(0.2, 0.4, 0.3), cube(1.6, 0.4, 0.3 + 0.02 * diagonal), plate(), mast()}),
        boxes("SameShape", Truth::yes, {stick(0.2, 0.4, 0.3), block({1, 0.2, 0.1}, {1.2, 0.4, 1.3}), plate(), mast()}),
        boxes("SameShape", Truth::no, {stick(0.2, 0.4, 0.3), cube(1, 0.4, 0.3), plate(), mast()}),
        boxes("SameShape", Truth::border,
              {stick(0.2, 0.4, 0.3), stick(1, 0.4, 0.3, 0.6 * std::exp(0.2)), plate(), mast()}),
        boxes("SameSize", Truth::yes, {stick(0.2, 0.4, 0.3), block({1, 0.2, 0.1}, {1.1, 0.3, 0.7}), plate(), mast()}),
        boxes("SameSize", Truth::no, {stick(0.2, 0.4, 0.3), block({1, 0.2, 0.1}, {1.2, 0.4, 1.3}), plate(), mast()}),
        boxes("SameSize", Truth::border,
              {stick(0.2, 0.4, 0.3), stick(1, 0.4, 0.3, 0.6 * std::exp(0.2)), plate(), mast()}),
        boxes("LongerThan", Truth::yes, {stick(0.2, 0.4, 0.3, 0.9), board(1.2, 0.2, 0.1), plate(), mast()}),
        boxes("LongerThan", Truth::no, {board(1.2, 0.2, 0.1), stick(0.2, 0.4, 0.3, 0.9), plate(), mast()}),
        boxes("LongerThan", Truth::no, {board(0.2, 0.2, 0.1), stick(1, 0.4, 0.3), plate(), mast()}),  // as long
        boxes("LongerThan", Truth::border, {stick(0.2, 0.4, 0.3, 0.72), stick(1.1, 0.4, 0.3), plate(), mast()}),
        boxes("ThickerThan", Truth::yes, {board(0.2, 0.2, 0.1, 0.2), stick(1, 0.4, 0.3), plate(), mast()}),
        boxes("ThickerThan", Truth::no, {stick(1, 0.4, 0.3), board(0.2, 0.2, 0.1, 0.2), plate(), mast()}),
        boxes("ThickerThan", Truth::no, {board(0.2, 0.2, 0.1), stick(1, 0.4, 0.3), plate(), mast()}),  // as thick
        boxes("ThickerThan", Truth::border, {board(0.2, 0.2, 0.1, 0.12), stick(1, 0.4, 0.3), plate(), mast()}),
        // A board has more surface than a block that fills more.
        boxes("LargerThan", Truth::yes,
              {board(0.2, 0.2, 0.1, 0.05), block({1, 0.2, 0.3}, {1.25, 0.45, 0.55}), plate(), mast()}),
        boxes("LargerThan", Truth::no,
              {block({1, 0.2, 0.3}, {1.25, 0.45, 0.55}), board(0.2, 0.2, 0.1, 0.05), plate(), mast()}),
        boxes("LargerThan", Truth::no, {stick(0.2, 0.4, 0.3), stick(1, 0.4, 0.3), plate(), mast()}),
        boxes("LargerThan", Truth::border,
              {block({0.2, 0.2, 0.1}, {0.2 + 0.3 * std::sqrt(1.4), 0.2 + 0.3 * std::sqrt(1.4), 0.1 + 0.3 * std::sqrt(1.4)}),
               block({1, 0.2, 0.3}, {1.3, 0.5, 0.6}), plate(), mast()}),
    };
    return all;
}

/// Round and angled shapes, by the middle of what they take up.
TriangleMesh moved_to(TriangleMesh mesh, const Vec3& at) {
    return solids::moved(std::move(mesh), [&](const Vec3& p) -> Vec3 { return p + at; });
}
TriangleMesh ball(const Vec3& at, double radius = 0.1) { return moved_to(solids::ball(radius, radius / 4), at); }
/// Along x, then turned about y (degrees, nose up) and about z.
TriangleMesh rod(const Vec3& at, double length = 0.6, double nose_up = 0, double about_z = 0, double radius = 0.05) {
    const double degree = std::numbers::pi / 180;
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(about_z * degree, Vec3::UnitZ()) * Eigen::AngleAxisd((90 - nose_up) * degree, Vec3::UnitY()))
            .toRotationMatrix();
    return solids::moved(solids::sweep(solids::ellipse(radius, radius, 0.016), length, 0.03),
                         [&](const Vec3& p) -> Vec3 { return turn * (p - Vec3(0, 0, length / 2)) + at; });
}
TriangleMesh disc(const Vec3& at, double radius = 0.25, double thickness = 0.08) {
    return moved_to(solids::sweep(solids::ellipse(radius, radius, 0.04), thickness, 0.04),
                    at - Vec3(0, 0, thickness / 2));
}
TriangleMesh ring(const Vec3& at, double radius = 0.25, double tube = 0.05) {
    return moved_to(solids::torus(radius, tube, 0.03), at);
}
/// A flat L whose inner corner looks towards x and y, or, mirrored, towards -x and y.
TriangleMesh ell(const Vec3& corner, bool is_mirrored = false, double arm = 0.4) {
    constexpr double half = 0.05;
    TriangleMesh mesh = solids::sweep(
        solids::polygon({{-half, -half}, {arm, -half}, {arm, half}, {half, half}, {half, arm / 2}, {-half, arm / 2}},
                        0.04),
        0.06, 0.03);
    if (is_mirrored) {
        for (Vec3& p : mesh.positions) p.x() *= -1;
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    }
    return moved_to(std::move(mesh), corner);
}

/// These shapes, and boxes that the object needs besides.
Case shapes(const std::string& relation, Truth truth, std::vector<TriangleMesh> meshes, double tolerance = 0.02,
            std::vector<solids::Block> besides = {plate(), mast()}) {
    return {relation, truth,
            [meshes, besides](Stage& stage, int steps) {
                for (const TriangleMesh& mesh : meshes) stage.add(mesh);
                for (const solids::Block& each : besides) stage.add(each, steps);
            },
            tolerance};
}

std::vector<Case> round_cases() {
    const double diagonal = std::sqrt(4.0 + 1 + 1);
    // One above the other, so that their poles are exactly so far apart.
    const auto balls = [&](double share) {
        return std::vector{ball({0.6, 0.5, 0.1}), ball({0.6, 0.5, 0.3 + share * diagonal})};
    };
    // A ring of which the first `share` is there.
    const auto arc = [](const Vec3& at, double share) {
        TriangleMesh mesh = ring(Vec3::Zero());
        std::erase_if(mesh.triangles, [&](const std::array<std::int32_t, 3>& corners) {
            Vec3 middle = Vec3::Zero();
            for (const std::int32_t v : corners) middle += mesh.positions[static_cast<std::size_t>(v)] / 3;
            return std::atan2(middle.y(), middle.x()) > std::numbers::pi * (2 * share - 1);
        });
        return moved_to(std::move(mesh), at);
    };
    return {
        shapes("Connected", Truth::yes, {ball({0.6, 0.5, 0.3}, 0.15), rod({0.6, 0.5, 0.5})}),
        shapes("Connected", Truth::yes, {ring({0.6, 0.5, 0.3}), rod({0.6, 0.5, 0.4})}),
        shapes("Connected", Truth::no, {ring({0.6, 0.5, 0.3}), ball({0.6, 0.5, 0.3}, 0.08)}),
        shapes("Connected", Truth::border, balls(0.01)),
        shapes("Close", Truth::yes, balls(0.02)),
        shapes("Close", Truth::no, balls(0.15)),
        shapes("Close", Truth::border, balls(0.075)),
        shapes("Far", Truth::yes, {ball({0.3, 0.5, 0.3}), ring({1.4, 0.5, 0.3})}),
        shapes("Far", Truth::no, balls(0.1)),
        shapes("Far", Truth::border, balls(0.2)),
        shapes("TouchesAlong", Truth::yes, {rod({0.6, 0.5, 0.3}), rod({0.6, 0.6, 0.3})}),
        shapes("TouchesAlong", Truth::no, {rod({0.6, 0.5, 0.38}, 0.6, 90), disc({0.6, 0.5, 0.04})}),
        shapes("TouchesAlong", Truth::no, {rod({0.6, 0.5, 0.3}), rod({0.6, 0.5, 0.4}, 0.6, 0, 90)}),
        shapes("UpFrom", Truth::yes, {ball({0.6, 0.5, 0.6}), disc({0.6, 0.5, 0.2})}),
        shapes("UpFrom", Truth::yes, {ring({0.6, 0.5, 0.6}), ell({0.5, 0.4, 0.1})}),
        shapes("UpFrom", Truth::no, {ball({0.6, 0.5, 0.2}), disc({1.2, 0.5, 0.2})}),
        shapes("UpFrom", Truth::border, {ball({0.6, 0.5, 0.34}), disc({0.6, 0.5, 0.3})}),
        shapes("Below", Truth::yes, {disc({0.6, 0.5, 0.2}), ball({0.6, 0.5, 0.6})}),
        shapes("Below", Truth::no, {ball({0.6, 0.5, 0.6}), disc({0.6, 0.5, 0.2})}),
        shapes("Below", Truth::border, {ball({0.6, 0.5, 0.26}), disc({0.6, 0.5, 0.3})}),
        shapes("Beside", Truth::yes, {ball({0.5, 0.5, 0.3}), rod({0.75, 0.5, 0.3}, 0.6, 90)}),
        shapes("Beside", Truth::no, {ring({0.6, 0.5, 0.6}), disc({0.6, 0.5, 0.2})}),
        shapes("Beside", Truth::border, {ball({0.5, 0.5, 0.3}), ball({0.8, 0.5, 0.43})}),
        shapes("InFrontOf", Truth::yes, {ball({0.5, 0.2, 0.1}), rod({0.5, 0.7, 0.3}, 0.6, 90)}, 0.02,
               {plate(), back()}),
        shapes("InFrontOf", Truth::no, {rod({0.5, 0.7, 0.3}, 0.6, 90), ball({0.5, 0.2, 0.1})}, 0.02, {plate(), back()}),
        shapes("InFrontOf", Truth::border, {ball({0.5, 0.4, 0.1}), ball({0.9, 0.5, 0.1})}, 0.02, {plate(), back()}),
        shapes("InFrontOf", Truth::unknown, {ball({0.9, 0.2, 0.1}), ball({0.9, 0.8, 0.1})}, 0.02, {plate()}),
        shapes("Behind", Truth::yes, {rod({0.5, 0.7, 0.3}, 0.6, 90), ball({0.5, 0.2, 0.1})}, 0.02, {plate(), back()}),
        shapes("Behind", Truth::no, {ball({0.5, 0.2, 0.1}), rod({0.5, 0.7, 0.3}, 0.6, 90)}, 0.02, {plate(), back()}),
        shapes("Behind", Truth::border, {ball({0.5, 0.5, 0.1}), ball({0.9, 0.4, 0.1})}, 0.02, {plate(), back()}),
        shapes("Between", Truth::yes, {ball({0.9, 0.5, 0.3}), rod({0.4, 0.5, 0.3}), ring({1.5, 0.5, 0.3})}),
        shapes("Between", Truth::no, {ball({0.2, 0.5, 0.3}), ball({0.8, 0.5, 0.3}), ring({1.5, 0.5, 0.3})}),
        shapes("Between", Truth::no, {rod({0.9, 0.38, 0.3}, 1), ball({0.5, 0.5, 0.3}, 0.06), ring({1.5, 0.5, 0.3})}),
        shapes("Between", Truth::border, {ball({1, 0.37, 0.3}), ball({0.5, 0.5, 0.3}), ball({1.5, 0.5, 0.3})}, 0.1),
        shapes("Inside", Truth::yes, {ball({0.6, 0.5, 0.3}, 0.08), ring({0.6, 0.5, 0.3}, 0.25, 0.12)}),
        shapes("Inside", Truth::no, {ball({0.6, 0.5, 0.5}, 0.04), ring({0.6, 0.5, 0.3})}),
        // Of a rod's surface, 0.8 is its lower end and 0.415 of its 0.5.
        {"Inside", Truth::border,
         [](Stage& stage, int steps) {
             stage.add(rod({0.6, 0.5, 0.35}, 0.5, 90));
             for (const solids::Block& each : {block({0.4, 0.3, 0}, {0.8, 0.7, 0.515}), plate(), mast()})
                 stage.add(each, steps);
         },
         0.1},
        shapes("Around", Truth::yes, {ring({0.6, 0.5, 0.3}), ball({0.6, 0.5, 0.3})}),
        shapes("Around", Truth::yes, {ring({0.6, 0.5, 0.3}), rod({0.6, 0.5, 0.3}, 0.6, 90)}),
        shapes("Around", Truth::no, {ball({0.6, 0.5, 0.3}), ring({0.6, 0.5, 0.3})}),
        shapes("Around", Truth::no, {ell({0.5, 0.4, 0.1}), ball({0.75, 0.6, 0.13}, 0.06)}),
        shapes("Around", Truth::border, {arc({0.6, 0.5, 0.3}, 0.8), ball({0.6, 0.5, 0.3})}, 0.12),
        shapes("Parallel", Truth::yes, {rod({0.6, 0.3, 0.3}), rod({1.2, 0.6, 0.5})}),
        shapes("Parallel", Truth::yes, {ell({0.5, 0.4, 0.1}), disc({1.2, 0.5, 0.6})}),
        shapes("Parallel", Truth::yes, {ring({0.6, 0.5, 0.3}), rod({1.3, 0.5, 0.6}, 0.6, 0, 30)}),
        shapes("Parallel", Truth::no, {rod({0.6, 0.3, 0.3}), rod({1.2, 0.6, 0.5}, 0.6, 40)}),
        shapes("Parallel", Truth::border, {rod({0.6, 0.3, 0.3}), rod({1.2, 0.6, 0.5}, 0.6, 10)}, 0.1),
        shapes("Orthogonal", Truth::yes, {rod({0.6, 0.5, 0.38}, 0.6, 90), disc({0.6, 0.5, 0.04})}),
        shapes("Orthogonal", Truth::yes, {rod({0.6, 0.5, 0.5}, 0.6, 0, 90), rod({1.2, 0.5, 0.3})}),
        shapes("Orthogonal", Truth::no, {rod({0.6, 0.5, 0.3}, 0.6, 0, 20), ring({1.2, 0.5, 0.1})}),
        shapes("Orthogonal", Truth::border, {rod({0.6, 0.5, 0.5}, 0.6, 0, 80), rod({1.2, 0.5, 0.3})}, 0.1),
        shapes("Coplanar", Truth::yes, {disc({0.4, 0.5, 0.3}), ring({1.3, 0.5, 0.3})}),
        shapes("Coplanar", Truth::no, {disc({0.4, 0.5, 0.3}), disc({1.3, 0.5, 0.6})}),
        shapes("Coplanar", Truth::no, {rod({0.4, 0.5, 0.3}), rod({1.3, 0.5, 0.3})}),
        shapes("Coplanar", Truth::border, {disc({0.4, 0.5, 0.3}), disc({1.3, 0.5, 0.3 + 0.02 * diagonal})}, 0.1),
        shapes("Collinear", Truth::yes, {rod({0.4, 0.5, 0.3}), rod({1.3, 0.5, 0.3})}),
        shapes("Collinear", Truth::no, {rod({0.4, 0.5, 0.3}), rod({0.4, 0.7, 0.3})}),
        shapes("Collinear", Truth::border, {rod({0.4, 0.5, 0.3}), rod({1.3, 0.5 + 0.02 * diagonal, 0.3})}, 0.1),
        shapes("Aligned", Truth::yes, {ball({0.3, 0.5, 0.3}), ring({1.2, 0.5, 0.3})}),
        shapes("Aligned", Truth::no, {ball({0.3, 0.5, 0.3}), ring({1.2, 0.6, 0.6})}),
        shapes("Aligned", Truth::border, {ball({0.3, 0.5, 0.3}), ball({1.2, 0.5 + 0.02 * diagonal, 0.3})}),
        shapes("Symmetric", Truth::yes, {ell({0.2, 0.4, 0.1}, false, 0.7), ell({1.8, 0.4, 0.1}, true, 0.7)}),
        shapes("Symmetric", Truth::yes, {ball({0.4, 0.5, 0.3}), ball({1.6, 0.5, 0.3})}),
        shapes("Symmetric", Truth::no, {ell({0.2, 0.4, 0.1}, false, 0.7), ell({1.15, 0.4, 0.1}, false, 0.7)}),
        shapes("Symmetric", Truth::border, {ball({0.4, 0.5, 0.3}), ball({1.6, 0.5, 0.3 + 0.02 * diagonal})}),
        shapes("SameShape", Truth::yes, {ball({0.4, 0.5, 0.3}, 0.2), ball({1.4, 0.5, 0.4}, 0.3)}),
        shapes("SameShape", Truth::yes,
               {rod({0.5, 0.5, 0.3}, 0.6, 0, 0, 0.08), rod({1.3, 0.5, 0.4}, 0.9, 0, 20, 0.12)}),
        shapes("SameShape", Truth::no, {rod({0.5, 0.5, 0.3}), ball({1.4, 0.5, 0.4})}),
        shapes("SameShape", Truth::border, {rod({0.5, 0.5, 0.3}), rod({1.3, 0.5, 0.4}, 0.6 * std::exp(0.2))}, 0.1),
        shapes("SameSize", Truth::yes, {rod({0.5, 0.5, 0.3}), rod({1.3, 0.5, 0.4}, 0.6, 0, 40)}),
        shapes("SameSize", Truth::no, {ball({0.4, 0.5, 0.3}), ball({1.4, 0.5, 0.4}, 0.2)}),
        shapes("SameSize", Truth::border, {rod({0.5, 0.5, 0.3}), rod({1.3, 0.5, 0.4}, 0.6 * std::exp(0.2))}, 0.1),
        shapes("LongerThan", Truth::yes, {rod({0.6, 0.5, 0.3}, 0.9, 0, 30), ring({1.4, 0.5, 0.3})}),
        shapes("LongerThan", Truth::no, {ball({1.4, 0.5, 0.3}), rod({0.6, 0.5, 0.3}, 0.6, 50)}),
        shapes("LongerThan", Truth::border, {rod({0.6, 0.5, 0.3}, 0.72), rod({1.4, 0.5, 0.3})}, 0.1),
        shapes("ThickerThan", Truth::yes, {ball({0.4, 0.5, 0.3}), rod({1.2, 0.5, 0.3})}),
        shapes("ThickerThan", Truth::no, {disc({1.2, 0.5, 0.3}), ball({0.4, 0.5, 0.3})}),
        shapes("ThickerThan", Truth::border, {ball({0.4, 0.5, 0.3}, 0.12), ball({1.4, 0.5, 0.3})}, 0.1),
        shapes("LargerThan", Truth::yes, {disc({0.4, 0.5, 0.3}), ball({1.4, 0.5, 0.3})}),
        shapes("LargerThan", Truth::no, {rod({0.4, 0.5, 0.3}), ring({1.4, 0.5, 0.3})}),
        shapes("LargerThan", Truth::border, {ball({0.4, 0.5, 0.3}, 0.1 * std::sqrt(1.4)), ball({1.4, 0.5, 0.3})}, 0.1),
        // A disc counts by its plane: what lies on it is parallel, what stands on it orthogonal.
        shapes("Orthogonal", Truth::no, {rod({0.6, 0.5, 0.38}), disc({0.6, 0.5, 0.04})}),
        shapes("Parallel", Truth::yes, {rod({0.6, 0.5, 0.38}), disc({0.6, 0.5, 0.04})}),
        shapes("Parallel", Truth::no, {rod({0.6, 0.5, 0.38}, 0.6, 90), disc({0.6, 0.5, 0.04})}),
    };
}

}  // namespace

std::vector<RelationCase> relation_cases() {
    std::vector<RelationCase> all = box_cases();
    for (RelationCase& each : round_cases()) all.push_back(std::move(each));
    return all;
}

}  // namespace partonomy
