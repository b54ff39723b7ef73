#include <gtest/gtest.h>

#include "adapters/asr/sphinx/noise_gate.hpp"
#include "tests/support/audio/sounds.hpp"

namespace parlour::adapters::asr {
namespace {

using test::Sound;

Sound gated(const Sound& sound) {
  NoiseGate gate;
  Sound all;
  for (std::size_t at = 0; at < sound.size(); at += 100) {
    const auto passed = gate.take(std::span(sound).subspan(
        at, std::min<std::size_t>(100, sound.size() - at)));
    all.insert(all.end(), passed.begin(), passed.end());
  }
  const auto rest = gate.finish();
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

double level(const Sound& sound, std::int64_t from, std::int64_t to) {
  return test::level_of(std::span(sound).subspan(test::samples_in(from),
                                                 test::samples_in(to - from)));
}

TEST(NoiseGateTest, SilencesWhatIsAroundSpeech) {
  auto sound = test::pink_noise(1, 2'000, -50);
  test::add(sound, test::tone(300, 600, -25), test::samples_in(700));
  const auto made = gated(sound);
  ASSERT_EQ(made.size(), sound.size());
  EXPECT_LT(level(made, 50, 600), -80);
  EXPECT_LT(level(made, 1'400, 2'000), -80);
  // What is near belongs to the speech, and the speech stays as it is.
  EXPECT_NEAR(level(made, 660, 690), level(sound, 660, 690), 1);
  for (auto i = test::samples_in(720); i < test::samples_in(1'280); ++i)
    ASSERT_NEAR(made[i], sound[i], 2);
}

TEST(NoiseGateTest, LeavesSpeechAloneThatBeginsAtOnce) {
  const auto sound = test::speech_like(3, 1'500, -25);
  const auto made = gated(sound);
  ASSERT_EQ(made.size(), sound.size());
  EXPECT_NEAR(test::level_of(made), test::level_of(sound), 0.5);
}

TEST(NoiseGateTest, TakesAnyLength) {
  EXPECT_TRUE(gated({}).empty());
  EXPECT_EQ(gated(Sound(7)).size(), 7u);
  EXPECT_EQ(gated(test::tone(300, 40, -20)).size(), test::samples_in(40));
}

} // namespace
} // namespace parlour::adapters::asr
