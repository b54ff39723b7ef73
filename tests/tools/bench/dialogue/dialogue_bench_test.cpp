#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/dialogue/dialogue_bench.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DialogueBench, a_row_tells_its_figure_and_its_bar) {
  std::ostringstream out;
  EXPECT_TRUE(dialogue_bench({1, "turns"}, out));
  EXPECT_THAT(out.str(), HasSubstr("a turn of the user"));
  EXPECT_THAT(out.str(), HasSubstr("bar 500"));
  EXPECT_THAT(out.str(), Not(HasSubstr("an event")));
}

TEST(DialogueBench, has_rows) {
  EXPECT_THAT(dialogue_bench_rows(), ElementsAre("turns", "events"));
}

} // namespace
} // namespace parlour::tools
