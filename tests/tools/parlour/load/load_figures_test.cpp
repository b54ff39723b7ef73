#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tools/parlour/load/load_figures.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(LoadFigures, TellWhatHasHappened) {
  LoadFigures figures;
  for (int i = 1; i <= 100; ++i)
    figures.answered(Milliseconds(i));
  figures.opened(Milliseconds(7));
  figures.finished();
  EXPECT_TRUE(figures.all_right());
  const auto lines = figures.lines(std::chrono::seconds(2));
  EXPECT_EQ(lines.at(0), "1 conversations, 100 turns in 2.00 s: 50 turns/s");
  EXPECT_EQ(lines.at(1), "a turn's answer: p50 51.00 ms, p95 96.00 ms, p99 "
                         "100.00 ms, max 100.00 ms");
  EXPECT_THAT(lines.at(2), HasSubstr("p50 7.00 ms"));
  EXPECT_EQ(lines.at(3), "0 wrong answers, 0 errors");
}

TEST(LoadFigures, TellEachPlaceOnce) {
  LoadFigures figures;
  figures.wrong("one.txt:3");
  figures.wrong("one.txt:3");
  figures.failed("gone");
  EXPECT_FALSE(figures.all_right());
  const auto lines = figures.lines(std::chrono::seconds(1));
  EXPECT_THAT(lines, Contains("2 times: one.txt:3"));
  EXPECT_THAT(lines, Contains("1 times: gone"));
  EXPECT_THAT(lines, Contains("a turn's answer: none"));
  for (int i = 0; i < 100; ++i)
    figures.failed(std::to_string(i));
  EXPECT_THAT(figures.lines(std::chrono::seconds(1)).back(),
              HasSubstr("82 more"));
}

TEST(LoadFigures, KnowTheMemoryOfAProcess) {
  EXPECT_GT(memory_of(static_cast<std::uint64_t>(getpid())), 1'000'000);
  EXPECT_EQ(memory_of(0), 0);
}

} // namespace
} // namespace parlour::tools
