#include "algorithms/measures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.h"

namespace partonomy {
namespace {

/// An object 2 high with its foot at z = 1, so that mistakes about the origin show.
Object tall_object(std::optional<double> metres_per_unit = 1.0) {
    Object object;
    object.low = 1;
    object.high = 3;
    object.placement.metres_per_unit = metres_per_unit;
    return object;
}

RegionMeasurements region_between(double low, double high) {
    RegionMeasurements region;
    region.lengths = Vec3(4, 2, 0.5);
    region.low = low;
    region.high = high;
    region.area = 3;
    return region;
}

double value(const char* name, const Object& object, const RegionMeasurements& region) {
    const Measure* measure = find_measure(name);
    EXPECT_NE(measure, nullptr) << name;
    return evaluate(*measure, object, region).value();
}

/// One box as a mesh and as the part that find_parts would make of it.
struct Box {
    Object object;
    PartRegion part;
};

Box box(const Vec3& lengths, const Eigen::Matrix3d& axes) {
    Box result;
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner((i & 1) ? 0.5 : -0.5, (i & 2) ? 0.5 : -0.5, (i & 4) ? 0.5 : -0.5);
        mesh.positions.push_back(axes * corner.cwiseProduct(lengths));
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    for (int t = 0; t < 12; ++t) {
        mesh.input_faces.push_back(t);
        result.part.region.triangles.push_back(t);
        result.part.region.memberships.push_back(1);
    }
    mesh.input_face_count = 12;
    result.object = make_object(mesh, {});
    result.part.box = {Vec3::Zero(), axes, lengths};
    return result;
}

Eigen::Matrix3d tilted(double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    Eigen::Matrix3d axes;
    axes << std::cos(a), 0, -std::sin(a), 0, 1, 0, std::sin(a), 0, std::cos(a);
    return axes;
}

TEST(Measures, RatiosOfTheBox) {
    const Object object = tall_object();
    const RegionMeasurements region = region_between(1, 3);
    EXPECT_DOUBLE_EQ(value("l0/l1", object, region), 2);
    EXPECT_DOUBLE_EQ(value("l1/l2", object, region), 4);
    EXPECT_DOUBLE_EQ(value("l0/l2", object, region), 8);
}

TEST(Measures, FlatBoxIsInfinitelyFlat) {
    RegionMeasurements region = region_between(1, 1);
    region.lengths[2] = 0;
    EXPECT_EQ(value("l1/l2", tall_object(), region), std::numeric_limits<double>::infinity());
}

TEST(Measures, EndHeightLooksAtTheNearerEnd) {
    const Object object = tall_object();
    EXPECT_DOUBLE_EQ(value("end height", object, region_between(1, 2.9)), 0);      // a leg that almost reaches the top
    EXPECT_DOUBLE_EQ(value("end height", object, region_between(2.9, 3)), 1);      // a tabletop
    EXPECT_DOUBLE_EQ(value("end height", object, region_between(1.6, 1.8)), 0.3);  // a seat
    EXPECT_DOUBLE_EQ(value("end height", object, region_between(1, 3)), 0);        // a side wall stands on the ground
    EXPECT_DOUBLE_EQ(value("end height", object, region_between(1.75, 2.75)), 0.875);
}

TEST(Measures, MetresNeedAUnit) {
    const RegionMeasurements region = region_between(1.5, 2);
    EXPECT_DOUBLE_EQ(value("top height", tall_object(0.01), region), 0.01);
    EXPECT_DOUBLE_EQ(value("area", tall_object(0.01), region), 3e-4);
    for (const Measure& measure : all_measures())
        if (measure.effort == Effort::at_once || measure.needs_metres) {
            if (measure.name == std::string("volume")) continue;  // of triangles, which this region has not
            EXPECT_EQ(evaluate(measure, tall_object(std::nullopt), region).has_value(), !measure.needs_metres)
                << measure.name;
        }
}

TEST(Measures, InclinationOfBoardStickAndBlock) {
    for (const double tilt : {0.0, 20.0, 45.0, 70.0, 90.0}) {
        SCOPED_TRACE(tilt);
        const Box board = box(Vec3(4, 3, 0.2), tilted(tilt));
        EXPECT_NEAR(measure_region(board.object, board.part).inclination, tilt, 1e-9);
        const Box stick = box(Vec3(4, 0.3, 0.2), tilted(tilt));
        EXPECT_NEAR(measure_region(stick.object, stick.part).inclination, tilt, 1e-9);
    }
    const Box cube =
        box(Vec3(1.02, 1.01, 1), tilted(90));  // its shortest axis lies, yet it is as horizontal as any cube
    EXPECT_NEAR(measure_region(cube.object, cube.part).inclination, 0, 1e-6);
}

TEST(Measures, AStraySliverDoesNotMoveTheEnds) {
    Box board = box(Vec3(4, 3, 0.2), tilted(0));
    TriangleMesh mesh = board.object.mesh;
    mesh.positions.insert(mesh.positions.end(), {Vec3(0, 0, 5), Vec3(0.01, 0, 5), Vec3(0, 0.01, 5)});
    mesh.triangles.push_back({8, 9, 10});
    mesh.input_faces.push_back(12);
    mesh.input_face_count = 13;
    board.part.region.triangles.push_back(12);
    board.part.region.memberships.push_back(1);
    const Object object = make_object(mesh, {});
    EXPECT_NEAR(measure_region(object, board.part).high, 0.1, 1e-12);
    EXPECT_NEAR(measure_region(object, board.part).low, -0.1, 1e-12);
    EXPECT_DOUBLE_EQ(object.high, 5);
}

TEST(Placement, WordsForAxesAndUnits) {
    EXPECT_EQ(parse_up("-y"), Vec3(0, -1, 0));
    EXPECT_EQ(parse_up("+z"), Vec3(0, 0, 1));
    EXPECT_EQ(parse_unit("in"), 0.0254);
    EXPECT_EQ(parse_unit("auto"), std::nullopt);
    EXPECT_THROW(static_cast<void>(parse_up("w")), UsageError);
    EXPECT_THROW(static_cast<void>(parse_unit("feet")), UsageError);
}

}  // namespace
}  // namespace partonomy
