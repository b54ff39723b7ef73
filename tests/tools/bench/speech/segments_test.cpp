#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/mixing.hpp"
#include "tools/bench/speech/segments.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;

TEST(Segments, are_missed_merged_and_found) {
  const std::vector<Segment> said{{1000, 2000}, {3000, 4000}, {5000, 6000}};
  const auto score =
      compare_segments(said, {{0, 100}, {1040, 4100}, {8000, 9000}});
  EXPECT_EQ(score.said, 3u);
  EXPECT_EQ(score.missed, 1u);
  EXPECT_EQ(score.merged, 1u);
  EXPECT_EQ(score.false_alarms, 2u);
  EXPECT_THAT(score.delays, ElementsAre(40));
}

TEST(Segments, begin_early_or_late) {
  const auto score = compare_segments({{1000, 2000}, {3000, 4000}},
                                      {{990, 2000}, {2900, 3500}});
  EXPECT_THAT(score.delays, ElementsAre(10, 100));
}

TEST(Segments, of_a_fixed_level_go_on_for_a_while) {
  auto sound = adapters::white_noise(1, 200, -20);
  sound.resize(adapters::samples_in(1'000));
  EXPECT_THAT(by_fixed_level(sound, -30), ElementsAre(Segment{0, 500}));
  EXPECT_TRUE(by_fixed_level(sound, -10).empty());
}

} // namespace
} // namespace parlour::tools
