#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/vad/silero_stream.hpp"
#include "tests/support/audio/sounds.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<double> often(double likely) {
  return std::vector<double>(15, likely); // 480 ms
}

TEST(SileroStreamTest, EdgesHaveThePositionsOfTheStream) {
  SileroStream stream(200, 10, 5'000);
  stream.hear(test::tone(300, 480, -20));
  EXPECT_THAT(stream.judged(often(0)), IsEmpty());
  stream.hear(test::tone(300, 480, -20));
  EXPECT_THAT(stream.judged(often(1)), ElementsAre(SpeechEdge{true, 5'480}));
  EXPECT_TRUE(stream.follows(5'960));
  EXPECT_FALSE(stream.follows(0));
  EXPECT_THAT(stream.finish(), ElementsAre(SpeechEdge{false, 5'960}));
}

TEST(SileroStreamTest, TheRobotsOwnVoiceIsNone) {
  SileroStream stream(200, 10, 0);
  for (int at = 0; at < 480; at += 20) {
    stream.hear_echo(test::tone(300, 20, -20));
    stream.hear(test::tone(300, 20, -40));
  }
  EXPECT_THAT(stream.judged(often(1)), IsEmpty());
  // But who speaks louder is heard.
  for (int at = 0; at < 480; at += 20) {
    stream.hear_echo(test::tone(300, 20, -20));
    stream.hear(test::tone(300, 20, -15));
  }
  EXPECT_THAT(stream.judged(often(1)), ElementsAre(SpeechEdge{true, 480}));
}

} // namespace
} // namespace parlour::adapters
