#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/endpointer/key_endpointing.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::int64_t frame = 20;

class KeyEndpointingTest : public testing::Test {
protected:
  // Hears numbered frames until this position, and notes what follows.
  void until(std::int64_t end) {
    for (; now < end; now += frame)
      note(endpointing.hear(now, now));
  }
  void note(const TurnSteps& steps) {
    for (const auto& step : steps) {
      if (const auto* audio = std::get_if<TurnAudio>(&step))
        audio_.push_back(audio->frame.integer_or(-1));
      else if (const auto* start = std::get_if<TurnStarted>(&step))
        seen.push_back("start " + std::to_string(start->position));
      else if (const auto* end = std::get_if<TurnEnded>(&step))
        seen.push_back("end " + std::to_string(end->position));
      else
        seen.push_back("dropped");
    }
  }
  void expect_audio(std::int64_t first, std::int64_t last) {
    std::vector<std::int64_t> expected;
    for (auto position = first; position <= last; position += frame)
      expected.push_back(position);
    EXPECT_EQ(audio_, expected);
  }

  KeyEndpointing endpointing{KeyEndpointTimes{}};
  std::int64_t now = 0;
  std::vector<std::string> seen;
  std::vector<std::int64_t> audio_;
};

TEST_F(KeyEndpointingTest, WithoutTheKeyThereIsNoTurn) {
  until(60'000);
  note(endpointing.released());
  until(61'000);
  EXPECT_THAT(seen, IsEmpty());
  EXPECT_THAT(audio_, IsEmpty());
}

TEST_F(KeyEndpointingTest, ATurnIsWhatIsSaidWhileTheKeyIsHeld) {
  until(1'020);
  note(endpointing.pressed());
  EXPECT_TRUE(endpointing.in_turn());
  until(2'020);
  note(endpointing.released());
  until(5'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 2000"));
  expect_audio(700, 2'200);
  EXPECT_FALSE(endpointing.in_turn());
}

TEST_F(KeyEndpointingTest, AClickIsNoTurn) {
  until(1'020);
  note(endpointing.pressed());
  until(1'120);
  note(endpointing.released());
  until(2'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "dropped"));
}

TEST_F(KeyEndpointingTest, WhoPressesAgainGoesOn) {
  until(1'020);
  note(endpointing.pressed());
  until(2'020);
  note(endpointing.released());
  until(2'120);
  note(endpointing.pressed());
  until(3'020);
  note(endpointing.released());
  note(endpointing.released());
  until(4'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 3000"));
  expect_audio(700, 3'200);
}

TEST_F(KeyEndpointingTest, CutsLongTurns) {
  until(20);
  note(endpointing.pressed());
  until(90'000);
  note(endpointing.released());
  until(91'000);
  EXPECT_THAT(seen,
              ElementsAre("start 0", "end 60000", "start 60000", "end 89980"));
  expect_audio(0, 90'180);
}

TEST_F(KeyEndpointingTest, EndsATurnWithoutAudio) {
  EXPECT_THAT(endpointing.finish(), IsEmpty());
  until(20);
  note(endpointing.pressed());
  until(1'000);
  note(endpointing.finish());
  EXPECT_THAT(seen, ElementsAre("start 0", "end 980"));
}

TEST_F(KeyEndpointingTest, StartsAnewAfterReset) {
  EXPECT_THAT(endpointing.reset(), IsEmpty());
  until(1'000);
  note(endpointing.pressed());
  note(endpointing.reset());
  note(endpointing.released());
  until(2'000);
  EXPECT_THAT(seen, ElementsAre("start 980", "dropped"));
}

} // namespace
} // namespace parlour::adapters
