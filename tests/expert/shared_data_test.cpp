/* Accuracy on test data beside the project; skipped when it is absent. The bars are those of the main job, the printed
 * figures are what was reached. */

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "base/files.h"
#include "expert/furniture.h"
#include "mesh/read_mesh.h"
#include "report/evaluate.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;
const fs::path data = PARTONOMY_SHARED_DATA;

struct NoiseLevel {
    const char* file;
    double accuracy;
    std::map<std::string, double> scores;  ///< Table 4 of the paper, by region
};

class Fig16 : public testing::TestWithParam<NoiseLevel> {};

TEST_P(Fig16, FourRegionsWithTheRightShapesAndScores) {
    const fs::path mesh_path = data / "fig16" / (std::string(GetParam().file) + ".ply");
    if (!fs::exists(mesh_path)) GTEST_SKIP() << "../shared/data/fig16 is absent";
    const LoadedMesh loaded = read_mesh(mesh_path);
    const std::string truth = read_file(data / "fig16" / (std::string(GetParam().file) + ".lab"));
    const Annotation annotation = Furniture::get().annotate(loaded.mesh);
    ASSERT_EQ(annotation.parts.size(), 4U);

    const std::vector<std::string> regions = {"cube", "vertical board", "horizontal board", "stick"};
    const std::map<std::string, std::string> shapes = {
        {"cube", "Cube"}, {"vertical board", "Board"}, {"horizontal board", "Board"}, {"stick", "Stick"}};
    std::int64_t right = 0;
    for (const AnnotatedPart& part : annotation.parts) {
        std::map<std::string, std::int64_t> counts;
        for (const int t : part.triangles)
            ++counts[regions[static_cast<std::size_t>(
                truth[static_cast<std::size_t>(loaded.mesh.input_faces[static_cast<std::size_t>(t)])])]];
        const auto best =
            std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) { return a.second < b.second; });
        right += best->second;
        EXPECT_EQ(part.features.at("Shape"), shapes.at(best->first)) << best->first;
        EXPECT_GE(part.score, GetParam().scores.at(best->first)) << best->first;
    }
    const double accuracy = static_cast<double>(right) / static_cast<double>(truth.size());
    std::cout << GetParam().file << ": face accuracy " << accuracy << "\n";
    EXPECT_GE(accuracy, GetParam().accuracy);
}

INSTANTIATE_TEST_SUITE_P(
    Noise, Fig16,
    testing::Values(
        NoiseLevel{"fig16_75k",
                   0.999,
                   {{"cube", .999966}, {"vertical board", .99997}, {"stick", .999915}, {"horizontal board", .99996}}},
        NoiseLevel{"fig16_75k_n05",
                   0.99,
                   {{"cube", .983023}, {"vertical board", .944411}, {"stick", .974192}, {"horizontal board", .95555}}},
        NoiseLevel{"fig16_75k_n10",
                   0.97,
                   {{"cube", .939295}, {"vertical board", .86583}, {"stick", .926152}, {"horizontal board", .876332}}}),
    [](const auto& level) { return std::string(level.param.file); });

std::map<std::string, std::string> up_axes() {
    std::ifstream file(data / "lpsb/up.csv");
    std::map<std::string, std::string> axes;
    for (std::string line; std::getline(file, line);)
        if (const auto comma = line.find(','); comma != std::string::npos)
            axes[line.substr(0, comma)] = line.substr(comma + 1);
    return axes;
}

class Lpsb : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(Lpsb, MeanAreaAccuracy) {
    const auto [kind, bar] = GetParam();
    const fs::path folder = data / "lpsb" / kind;
    if (!fs::exists(folder)) GTEST_SKIP() << "../shared/data/lpsb is absent";
    const std::map<std::string, std::string> names = {{"support", std::string(kind) == "chair" ? "Seat" : "Tabletop"},
                                                      {"backsupport", "Backrest"},
                                                      {"arm", "BackPost"},
                                                      {"leg", "Leg"}};
    double sum = 0;
    int count = 0;
    for (const auto& [mesh, up] : up_axes()) {
        if (!mesh.starts_with(kind)) continue;
        const fs::path path = data / "lpsb" / mesh;
        const LoadedMesh loaded = read_mesh(path.string() + ".off");
        const Annotation annotation = Furniture::get().annotate(loaded.mesh, {parse_up(up), 1.0});
        const Evaluation result = evaluate_labels(
            annotation.labels, read_truth(path.string() + "_labels.txt", loaded.mesh.input_face_count, names),
            input_face_areas(loaded.mesh));
        std::cout << mesh << " " << result.area_accuracy << "\n";
        EXPECT_FALSE(annotation.parts.empty()) << mesh;
        sum += result.area_accuracy;
        ++count;
    }
    ASSERT_EQ(count, 10);
    std::cout << kind << " mean " << sum / count << "\n";
    EXPECT_GE(sum / count, bar);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Lpsb, testing::Values(std::pair("chair", 0.80), std::pair("table", 0.92)),
                         [](const auto& kind) { return std::string(kind.param.first); });

}  // namespace
}  // namespace partonomy
