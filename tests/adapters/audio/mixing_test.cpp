#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/mixing.hpp"
#include "tests/adapters/audio/tones.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;

TEST(Mixing, LevelsAreOfTheMeanPower) {
  EXPECT_NEAR(level_of(test::tone(1'000, 1, 16'000)), -3.01, 0.05);
  EXPECT_NEAR(level_of(test::tone(1'000, 0.1, 16'000)), -23.01, 0.05);
  EXPECT_EQ(level_of(Sound(100)), -120);
  EXPECT_EQ(level_of({}), -120);
}

TEST(Mixing, PausesDoNotCountForSpeech) {
  auto sound = test::tone(1'000, 0.1, 16'000);
  sound.resize(64'000);
  EXPECT_NEAR(level_of(sound), -29.03, 0.05);
  EXPECT_NEAR(speech_level_of(sound), -23.01, 0.05);
}

TEST(Mixing, ASoundGetsALevel) {
  const auto louder = at_level(test::tone(1'000, 0.1, 16'000), -23, -13);
  EXPECT_NEAR(level_of(louder), -13, 0.05);
  EXPECT_THAT(at_level({20'000, -20'000}, 0, 20), ElementsAre(32'767, -32'768));
}

TEST(Mixing, ASoundIsAddedFromASampleOn) {
  Sound sound{1, 2, 3};
  add(sound, Sound{10, 20, 30}, 1);
  EXPECT_THAT(sound, ElementsAre(1, 12, 23));
  add(sound, Sound{32'767}, 2);
  EXPECT_THAT(sound, ElementsAre(1, 12, 32'767));
}

TEST(Mixing, SilenceAtTheEndsIsCut) {
  Sound sound(frame_samples * 3);
  const auto tone = test::tone(1'000, 0.1, frame_samples * 2);
  sound.insert(sound.end(), tone.begin(), tone.end());
  sound.resize(frame_samples * 9);
  EXPECT_EQ(without_silence(sound), tone);
  EXPECT_EQ(without_silence({}), Sound());
}

TEST(Mixing, NoiseHasALevelAndIsTheSameAgain) {
  for (auto* noise : {pink_noise, white_noise}) {
    const auto one = noise(1, 1'000, -30);
    EXPECT_EQ(one.size(), samples_in(1'000));
    EXPECT_NEAR(level_of(one), -30, 0.1);
    EXPECT_EQ(one, noise(1, 1'000, -30));
    EXPECT_NE(one, noise(2, 1'000, -30));
  }
}

// Most of the power of pink noise is in low sounds: neighbours are alike.
TEST(Mixing, PinkNoiseIsLow) {
  const auto alike = [](const Sound& sound) {
    double sum = 0;
    double power = 0;
    for (std::size_t i = 1; i < sound.size(); ++i) {
      sum += static_cast<double>(sound[i]) * sound[i - 1];
      power += static_cast<double>(sound[i]) * sound[i];
    }
    return sum / power;
  };
  EXPECT_GT(alike(pink_noise(1, 1'000, -30)), 0.5);
  EXPECT_LT(std::abs(alike(white_noise(1, 1'000, -30))), 0.1);
}

} // namespace
} // namespace parlour::adapters
