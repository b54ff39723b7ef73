#include <gtest/gtest.h>

#include "adapters/vad/detector_options.hpp"

namespace parlour::adapters {
namespace {

TEST(DetectorOptionsTest, HaveDefaults) {
  const auto options = read_detector_options({});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->hangover, 200);
  EXPECT_EQ(options->echo_loss, 10);
}

TEST(DetectorOptionsTest, AreReadWithinTheirBounds) {
  const auto options =
      read_detector_options({{"hangover", "2s"}, {"echo-loss", "0"}});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->hangover, 2'000);
  EXPECT_EQ(options->echo_loss, 0);
  EXPECT_FALSE(read_detector_options({{"hangover", "39ms"}}));
  EXPECT_FALSE(read_detector_options({{"hangover", "2001ms"}}));
  EXPECT_FALSE(read_detector_options({{"echo-loss", "61"}}));
  EXPECT_FALSE(read_detector_options({{"echo-loss", "-1"}}));
  EXPECT_FALSE(read_detector_options({{"echo-loss", "much"}}));
}

TEST(DetectorOptionsTest, FollowADetectorsOwn) {
  const auto all = detector_options({{"own", "1", "its own"}});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.front().name, "own");
}

} // namespace
} // namespace parlour::adapters
