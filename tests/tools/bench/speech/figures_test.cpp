#include <gtest/gtest.h>

#include "tools/bench/speech/figures.hpp"

namespace parlour::tools {
namespace {

TEST(Figures, say_whether_the_bar_is_met) {
  EXPECT_EQ(figure_at_least(95, 95, " %"), "95.0 % (bar 95: met)");
  EXPECT_EQ(figure_at_least(94.94, 95, " %"), "94.9 % (bar 95: missed)");
  EXPECT_EQ(figure_at_most(1.5, 1.5, " s"), "1.5 s (bar 1.5: met)");
  EXPECT_EQ(figure_at_most(2, 1.5, " s"), "2.0 s (bar 1.5: missed)");
}

} // namespace
} // namespace parlour::tools
