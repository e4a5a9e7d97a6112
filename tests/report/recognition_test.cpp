#include "report/recognition.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace partonomy {
namespace {

using Classes = std::vector<std::string>;

TEST(Recognition, CountsRightAndWrongClasses) {
    Recognition found;
    found.add("chair1", "Chair", Classes{"Armchair", "Chair"});
    found.add("chair2", "Chair", Classes{"Table"});
    found.add("chair3", "Chair", Classes{});
    found.add("chair4", "Chair", std::nullopt);
    EXPECT_EQ(found.right, 1U);
    EXPECT_EQ(found.of_a_class(), 4U);
    EXPECT_EQ(found.classes_in_words(),
              "classes: 1 of 4 right; chair2 as Table instead of Chair; chair3 not recognised instead of Chair; "
              "chair4 without annotation.json instead of Chair");
}

TEST(Recognition, OfNoKind) {
    Recognition found;
    found.add_of_no_kind("rock", Classes{});
    EXPECT_EQ(found.no_kind_in_words(), "1 mesh of no kind: 1 rightly not recognised");
    found.add_of_no_kind("box", Classes{"Table"});
    found.add_of_no_kind("lost", std::nullopt);
    EXPECT_EQ(found.no_kind_in_words(),
              "3 meshes of no kind: 1 rightly not recognised, 1 recognised (box as Table), 1 without annotation.json "
              "(lost)");
    EXPECT_EQ(found.of_a_class(), 0U);
}

TEST(Recognition, ReadsClasses) {
    const auto classes = read_classes("# truth\nmeshes/chair1.off Chair\n\ntable 2\nrock,-  # of no kind\n", "c.txt");
    EXPECT_EQ(classes, (std::map<std::string, std::string>{{"chair1", "Chair"}, {"rock", "-"}, {"table", "2"}}));
    for (const char* wrong : {"a A\nb\n", "a A\nb B C\n", "a A\na.off B\n"}) try {
            static_cast<void>(read_classes(wrong, "c.txt"));
            ADD_FAILURE() << wrong;
        } catch (const UsageError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("c.txt:2: ")) << error.what();
        }
}

}  // namespace
}  // namespace partonomy
