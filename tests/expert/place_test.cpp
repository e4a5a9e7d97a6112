/* Up axis and unit found: the paper's objects whichever way they lie and whatever unit they are in, and the organic
 * chairs and tables beside the project, where naming must hardly suffer from not being told. */

#include "expert/place.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "examples/transforms.h"
#include "expert/furniture.h"
#include "mesh/read_mesh.h"
#include "report/evaluate.h"
#include "shape/resting.h"

namespace partonomy {
namespace {

constexpr std::array<const char*, 6> words = {"x", "-x", "y", "-y", "z", "-z"};

/// The mesh turned so that what was up, z, points along an axis direction, and scaled.
TriangleMesh turned(TriangleMesh mesh, const Vec3& up, double scale) {
    const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), up).toRotationMatrix();
    for (Vec3& position : mesh.positions) position = scale * (turn * position);
    return mesh;
}

Placing found(Object& object, const PlacingOptions& options = {}) {
    return find_placement(Furniture::get().domain, Furniture::get().catalogue, object, options);
}

class Placed : public testing::TestWithParam<std::string> {};

TEST_P(Placed, UpIsFoundWhicheverWayItLies) {
    const ExampleObject object = paper_object(GetParam());
    const Annotation original = Furniture::get().annotate(object.mesh);
    for (std::size_t k = 0; k < words.size(); ++k) {
        SCOPED_TRACE(words[k]);
        const TriangleMesh mesh = turned(object.mesh, axis_directions()[k], 1);
        Object unplaced = make_object(mesh, {resting_up(mesh), 1.0});
        const Placing placing = found(unplaced, {"auto", "m"});
        EXPECT_EQ(placing.up, words[k]);
        EXPECT_GT(placing.up_confidence, 0.5);
        EXPECT_EQ(placing.unit_confidence, 1);
        const Annotation annotation = annotate(Furniture::get().domain, Furniture::get().catalogue, unplaced);
        EXPECT_EQ(annotation.classes, original.classes);
        EXPECT_EQ(annotation.labels, original.labels);
    }
}

TEST_P(Placed, UnitIsFoundOrLeftOpen) {
    const std::map<std::string, double> units = {{"m", 1}, {"cm", 100}, {"mm", 1000}, {"in", 1 / 0.0254}};
    for (const auto& [unit, scale] : units) {
        SCOPED_TRACE(unit);
        const ExampleObject object = paper_object(GetParam());
        Object unplaced = make_object(turned(object.mesh, Vec3::UnitZ(), scale), {Vec3::UnitZ(), std::nullopt});
        const Placing placing = found(unplaced, {"z", "auto"});
        EXPECT_TRUE(placing.unit == unit || placing.unit == "unknown") << placing.unit;
        EXPECT_EQ(unplaced.placement.metres_per_unit.has_value(), placing.unit != "unknown");
        EXPECT_EQ(placing.up, "z");
    }
}

INSTANTIATE_TEST_SUITE_P(Table1, Placed, paper_object_names, without_dashes);

TEST(Placing, NoUnitIsGuessedForWhatIsOfNoTypicalSize) {
    const ExampleObject object = paper_object("chair");
    Object unplaced = make_object(turned(object.mesh, Vec3::UnitZ(), 7), {Vec3::UnitZ(), std::nullopt});
    EXPECT_EQ(found(unplaced, {"z", "auto"}).unit, "unknown");
    EXPECT_FALSE(unplaced.placement.metres_per_unit.has_value());
}

TEST(Placing, ATossUpIsTakenAsFilesMostlyAreAndSaysSo) {
    TriangleMesh box;  // looks the same upside down
    for (int corner = 0; corner < 8; ++corner)
        box.positions.emplace_back(corner & 1, (corner >> 1 & 1) * 0.5, (corner >> 2 & 1) * 0.3);
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        box.triangles.push_back({a, b, c});
        box.triangles.push_back({a, c, d});
    }
    box.input_face_count = 12;
    for (std::int32_t t = 0; t < 12; ++t) box.input_faces.push_back(t);
    for (const std::size_t k : {0U, 2U, 4U}) {
        SCOPED_TRACE(words[k]);
        Object unplaced = make_object(turned(box, axis_directions()[k], 1), {Vec3::UnitZ(), 1.0});
        const Placing placing = found(unplaced, {"auto", "m"});
        EXPECT_NE(placing.up.front(), '-');
        EXPECT_LT(placing.up_confidence, 0.6);
    }
}

TEST(Resting, AStoolStandsOnItsFeetAndAPostTopples) {
    const ExampleObject stool = paper_object("chair");
    const std::array<double, 6> scores = resting_scores(stool.mesh, compute_geometry(stool.mesh));
    EXPECT_GT(scores[4], 0.5);        // on its feet
    EXPECT_LT(scores[5], scores[4]);  // on its head
    for (const double score : scores) {
        EXPECT_GE(score, 0);
        EXPECT_LE(score, 1 + 1e-9);
    }
}

TEST(Placing, NamingHardlySuffersFromNotBeingTold) {
    const std::filesystem::path data = std::filesystem::path(PARTONOMY_SHARED_DATA) / "lpsb";
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "../shared/data/lpsb is absent";
    std::ifstream file(data / "up.csv");
    std::map<std::string, std::pair<double, double>> sums;  // by kind: told, found
    for (std::string line; std::getline(file, line);) {
        const auto comma = line.find(',');
        const std::string name = line.substr(0, comma), kind = name.substr(0, name.find('/'));
        if (comma == std::string::npos || kind == name) continue;
        const std::map<std::string, std::string> names = {{"support", kind == "chair" ? "Seat" : "Tabletop"},
                                                          {"backsupport", "Backrest"},
                                                          {"arm", "BackPost"},
                                                          {"leg", "Leg"}};
        const std::string path = (data / name).string();
        const LoadedMesh loaded = read_mesh(path + ".off");
        const std::vector<std::string> truth = read_truth(path + "_labels.txt", loaded.mesh.input_face_count, names);
        const auto accuracy = [&](const Object& object) {
            const Annotation annotation = annotate(Furniture::get().domain, Furniture::get().catalogue, object);
            return evaluate_labels(annotation.labels, truth, input_face_areas(loaded.mesh)).area_accuracy;
        };
        const double told = accuracy(make_object(loaded.mesh, {parse_up(line.substr(comma + 1)), 1.0}));
        Object unplaced = make_object(loaded.mesh, {resting_up(loaded.mesh), 1.0});
        const Placing placing = found(unplaced, {"auto", "m"});
        const double alone = accuracy(unplaced);
        std::cout << name << " told " << told << ", found " << placing.up << " (" << placing.up_confidence << ") "
                  << alone << "\n";
        sums[kind].first += told;
        sums[kind].second += alone;
    }
    for (const auto& [kind, sum] : sums) {
        std::cout << kind << " mean: told " << sum.first / 10 << ", found " << sum.second / 10 << "\n";
        EXPECT_GE(sum.second / 10, sum.first / 10 - 0.005) << kind;
    }
}

}  // namespace
}  // namespace partonomy
