#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/process/output_lines.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class OutputLinesTest : public testing::Test {
protected:
  std::vector<std::string> printed() {
    return std::exchange(printed_, {});
  }

private:
  std::vector<std::string> printed_;

protected:
  OutputLines lines{[this](const auto& line) { printed_.push_back(line); }};
};

TEST_F(OutputLinesTest, AreWholeLines) {
  lines.add("one\ntw", 0);
  EXPECT_THAT(printed(), ElementsAre("one"));
  lines.add("o\n\n \nthree", 0);
  EXPECT_THAT(printed(), ElementsAre("two"));
  lines.finish();
  EXPECT_THAT(printed(), ElementsAre("three"));
}

TEST_F(OutputLinesTest, AreCut) {
  for (int i = 0; i < 1'000; ++i)
    lines.add("0123456789", 0);
  lines.add("\nshort\n", 0);
  const auto all = printed();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].size(), OutputLines::longest + std::string(" …").size());
  EXPECT_EQ(all[1], "short");
}

TEST_F(OutputLinesTest, AreNoMoreThanTheLogBears) {
  for (int i = 0; i < 1'000; ++i)
    lines.add("again\n", 999);
  EXPECT_EQ(printed().size(), 20u);
  lines.add("later\n", 1'999);
  EXPECT_THAT(printed(), ElementsAre("(lines left out: 980)", "later"));
  for (int i = 0; i < 20; ++i)
    lines.add("again\n", 2'000);
  printed();
  lines.finish();
  EXPECT_THAT(printed(), ElementsAre("(lines left out: 1)"));
}

TEST_F(OutputLinesTest, AreTextAndGiveNoOrders) {
  lines.add("\x1b[2Jred\xff\n", 0);
  EXPECT_THAT(printed(), ElementsAre(" [2Jred?"));
  lines.finish();
  EXPECT_THAT(printed(), IsEmpty());
}

} // namespace
} // namespace parlour::adapters
