#include <gtest/gtest.h>

#include "tools/parlour/conversation_test/rewording.hpp"

namespace parlour::tools {
namespace {

TEST(Rewording, changes_the_words_alone) {
  EXPECT_EQ(reworded("# R: no\nR: old\n\nU: x\n\tR:   older \nR: stays",
                     {{2, "old", "new"}, {5, "older", "newer"}}),
            "# R: no\nR: new\n\nU: x\n\tR:   newer\nR: stays");
}

TEST(Rewording, keeps_the_ends_of_lines) {
  EXPECT_EQ(reworded("R: a\r\nR:b\r\nR: c",
                     {{1, "a", "x: y"}, {2, "b", "z"}, {3, "c", "R: w"}}),
            "R: x: y\r\nR:z\r\nR: R: w");
}

TEST(Rewording, of_nothing_is_the_same) {
  EXPECT_EQ(reworded("", {}), "");
  EXPECT_EQ(reworded("a\n\n", {}), "a\n\n");
}

} // namespace
} // namespace parlour::tools
