// Bent boards: with long flat sides and a tight bend they are two boards, with a gentle one they are one. And the
// corner of two sticks, which is the level one's.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>

#include "shape/find_parts.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

/// How a bent board runs: straight, around an arc, straight again.
struct Bend {
    double before, radius, degrees, after;
};

constexpr double thickness = 0.03, width = 0.4;

/// A board that runs along the bend in the plane of x and z; triangles with edges of about `step`.
TriangleMesh bent_board(const Bend& bend, double step) {
    struct Place {
        double x, z, angle;
    };
    std::vector<Place> places;
    const double angle = bend.degrees * std::numbers::pi / 180;
    const auto pieces = [&](double length, int least) { return std::max(least, static_cast<int>(length / step)); };
    const int first = pieces(bend.before, 1), round = pieces(bend.radius * angle, 9), second = pieces(bend.after, 1);
    if (bend.before > 0)
        for (int k = 0; k < first; ++k) places.push_back({bend.before * k / first, 0, 0});
    for (int k = 0; k <= round; ++k) {
        const double a = angle * k / round;
        places.push_back({bend.before + bend.radius * std::sin(a), bend.radius * (1 - std::cos(a)), a});
    }
    const Place end = places.back();
    if (bend.after > 0)
        for (int k = 1; k <= second; ++k)
            places.push_back({end.x + bend.after * std::cos(angle) * k / second,
                              end.z + bend.after * std::sin(angle) * k / second, angle});
    TriangleMesh mesh;
    const int across = pieces(width, 1), count = static_cast<int>(places.size());
    for (int j = 0; j <= across; ++j)
        for (const int side : {1, -1})
            for (const Place& place : places)
                mesh.positions.emplace_back(place.x - side * thickness / 2 * std::sin(place.angle), width * j / across,
                                            place.z + side * thickness / 2 * std::cos(place.angle));
    const auto at = [&](int j, int side, int k) { return (2 * j + side) * count + k; };
    const auto quad = [&](int a, int b, int c, int d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (int k = 0; k + 1 < count; ++k) {
        for (int j = 0; j < across; ++j) {
            quad(at(j, 0, k), at(j, 0, k + 1), at(j + 1, 0, k + 1), at(j + 1, 0, k));
            quad(at(j, 1, k), at(j + 1, 1, k), at(j + 1, 1, k + 1), at(j, 1, k + 1));
        }
        quad(at(0, 1, k), at(0, 1, k + 1), at(0, 0, k + 1), at(0, 0, k));
        quad(at(across, 1, k), at(across, 0, k), at(across, 0, k + 1), at(across, 1, k + 1));
    }
    for (int j = 0; j < across; ++j) {
        quad(at(j, 1, 0), at(j, 0, 0), at(j + 1, 0, 0), at(j + 1, 1, 0));
        quad(at(j, 1, count - 1), at(j + 1, 1, count - 1), at(j + 1, 0, count - 1), at(j, 0, count - 1));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.input_faces.push_back(static_cast<std::int32_t>(t));
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    return mesh;
}

TEST(BentBoard, IsTwoWhereTheBendIsTightAndOneWhereItIsGentle) {
    struct Case {
        const char* name;
        Bend bend;
        std::size_t parts;
    };
    for (const Case& each :
         {Case{"seat and back of one sheet", {0.45, 0.06, 90, 0.45}, 2}, Case{"tighter", {0.45, 0.03, 90, 0.3}, 2},
          Case{"leaning back", {0.45, 0.06, 65, 0.45}, 2},
          Case{"bent beyond a right angle", {0.45, 0.08, 110, 0.35}, 2}, Case{"arc of a quarter", {0, 0.5, 90, 0}, 1},
          Case{"longer arc", {0, 0.3, 150, 0}, 1}, Case{"arc with short ends", {0.2, 0.3, 90, 0.2}, 1},
          Case{"slight bend", {0.45, 0.06, 30, 0.45}, 1}})
        for (const double step : {0.02, 10.0}) {
            SCOPED_TRACE(testing::Message() << each.name << ", edges of " << step);
            const TriangleMesh mesh = bent_board(each.bend, step);
            EXPECT_EQ(find_parts(mesh).size(), each.parts);
        }
}

TEST(BentBoard, IsCutAtTheBend) {
    const TriangleMesh mesh = bent_board({0.45, 0.06, 90, 0.45}, 0.02);
    const std::vector<PartRegion> parts = find_parts(mesh);
    ASSERT_EQ(parts.size(), 2U);
    for (const PartRegion& part : parts) {
        bool is_level = false, is_upright = false;
        for (const std::int32_t t : part.region.triangles) {
            const Vec3& corner =
                mesh.positions[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][0])];
            is_level = is_level || corner.x() < 0.44;
            is_upright = is_upright || corner.z() > 0.08;
        }
        EXPECT_NE(is_level, is_upright);
    }
}

TEST(BentBoard, IsTwoAlsoWhereTheBackIsCurved) {
    for (const double bulge : {0.02, 0.05, 0.08}) {
        SCOPED_TRACE(bulge);
        const Bend bend{0.45, 0.06, 90, 0.45};
        TriangleMesh mesh = bent_board(bend, 0.008);
        enum class Side : std::uint8_t { seat, between, back };
        std::vector<Side> sides;
        for (Vec3& point : mesh.positions) {
            sides.push_back(point.z() > 0.08 ? Side::back : point.x() > 0.44 ? Side::between : Side::seat);
            const double aside = 2 * point.y() / width - 1;
            point.x() += bulge * (1 - aside * aside) * std::clamp(point.x() / bend.before, 0.0, 1.0);
        }
        const std::vector<PartRegion> parts = find_parts(mesh);
        ASSERT_EQ(parts.size(), 2U);
        for (const PartRegion& part : parts) {
            std::map<Side, int> votes;
            for (const std::int32_t t : part.region.triangles)
                ++votes[sides[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][0])]];
            const auto [few, many] = std::minmax(votes[Side::seat], votes[Side::back]);
            EXPECT_LT(few, 0.02 * many);
        }
    }
}

TEST(CornerOfSticks, IsTheLevelOnes) {
    const shapes::Labelled object =
        shapes::join({{Vec3(0, 0, 0), Vec3(1, 0.15, 0.15), 0}, {Vec3(0, 0, 0.15), Vec3(0.15, 0.15, 0.8), 1}}, 0.03);
    for (const bool is_hanging : {false, true}) {
        TriangleMesh mesh = object.mesh;
        if (is_hanging) shapes::turn(mesh, Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX())));
        const std::vector<PartRegion> parts = find_parts(mesh);
        ASSERT_EQ(parts.size(), 2U);
        for (const PartRegion& part : parts) {
            std::map<int, int> votes;
            for (const std::int32_t t : part.region.triangles) ++votes[object.parts[static_cast<std::size_t>(t)]];
            const auto [few, many] = std::minmax(votes[0], votes[1]);
            EXPECT_LT(few, 0.02 * many);
        }
    }
}

}  // namespace
}  // namespace partonomy
