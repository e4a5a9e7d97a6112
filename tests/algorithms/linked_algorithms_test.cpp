/* A file dropped into a folder is an algorithm of the program: examples/plugin, which the CMake file of these tests
 * links as that of the program links src/algorithms/linked. */

#include "algorithms/linked_algorithms.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "algorithms/measures.h"
#include "algorithms/plugins.h"
#include "base/errors.h"
#include "shape/solids.h"

namespace partonomy {
std::span<const LinkedAlgorithm> linked_examples();

namespace {

TEST(LinkedAlgorithms, EachFileOfTheFolderIsOne) {
    const auto files = [](const std::string& folder) {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(PARTONOMY_SOURCE_DIR "/" + folder))
            count += entry.path().extension() == ".cpp";
        return count;
    };
    EXPECT_EQ(linked_examples().size(), files("examples/plugin"));
    EXPECT_EQ(linked_algorithms().size(), files("src/algorithms/linked"));
    EXPECT_STREQ(linked_examples()[0].file, "top_heaviness.cpp");
}

TEST(LinkedAlgorithms, MeasuresLikeABuiltInOne) {
    add_linked_algorithms();
    for (const LinkedAlgorithm& each : linked_examples()) add_algorithm(each.entry(), each.file);
    const Measure* measure = find_measure("top heaviness");
    ASSERT_NE(measure, nullptr);
    const auto value = [&](double lid) {  // of a stick that widens or narrows towards its top
        const TriangleMesh mesh =
            solids::sweep(solids::rectangle(0.4, 0.4, 0.1), 1, 0.1, [=](double t, const Eigen::Vector2d& p) -> Vec3 {
                return {(1 + t * (lid - 1)) * p.x(), (1 + t * (lid - 1)) * p.y(), t};
            });
        const Object object = make_object(mesh, {});
        return evaluate(*measure, object, measure_region(object, object.candidates.at(0))).value();
    };
    EXPECT_GT(value(2), 0.6);
    EXPECT_LT(value(0.4), 0.4);
    EXPECT_THROW(add_algorithm(linked_examples()[0].entry(), "again"), FileError);  // the name is taken now
}

}  // namespace
}  // namespace partonomy
