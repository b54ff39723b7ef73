#include <gtest/gtest.h>

#include "tools/bench/speech/detector_row.hpp"

namespace parlour::tools {
namespace {

TEST(DetectorRow, has_pauses_between_lines) {
  const adapters::Sound line(adapters::samples_in(500), 1'000);
  const adapters::Sound noise(adapters::samples_in(300), 1);
  const auto row = in_a_row({&line, &line}, noise);
  ASSERT_EQ(row.said.size(), 2u);
  EXPECT_EQ(row.said[0], (Segment{2'400, 2'900}));
  EXPECT_EQ(row.said[1], (Segment{4'100, 4'600}));
  EXPECT_EQ(adapters::duration(row.sound.size()), 5'800);
  EXPECT_EQ(row.sound.front(), 1);
  EXPECT_EQ(row.sound[adapters::samples_in(2'500)], 1'001);
}

} // namespace
} // namespace parlour::tools
