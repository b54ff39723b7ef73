#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "adapters/enhancement/echo_canceller.hpp"
#include "tests/support/audio/sounds.hpp"

namespace parlour::adapters {
namespace {

using test::Sound;

// What a microphone hears of a loudspeaker: later, weaker, and again from the
// walls.
Sound echo_of(const Sound& played, std::int64_t delay) {
  Sound echo(played.size());
  constexpr std::array<std::pair<int, double>, 4> paths{
      {{0, 0.4}, {7, -0.15}, {19, 0.1}, {41, -0.05}}};
  for (const auto& [later, gain] : paths) {
    const auto decibels = 20 * std::log10(std::abs(gain));
    auto path = test::at_level(played, 0, decibels);
    if (gain < 0)
      std::ranges::transform(path, path.begin(), [](Sample sample) {
        return static_cast<Sample>(-sample);
      });
    test::add(echo, path, test::samples_in(delay + later));
  }
  return echo;
}

class EchoCancellerTest : public testing::Test {
protected:
  void SetUp() override {
    if (!EchoCanceller::make({}))
      GTEST_SKIP() << "built without libwebrtc-audio-processing";
  }

  // What comes out while `played` plays and `heard` is heard.
  static Sound enhanced(const Sound& played, const Sound& heard) {
    auto canceller = EchoCanceller::make({});
    Sound made;
    for (std::size_t at = 0; at < heard.size(); at += frame_samples) {
      const auto size = std::min(frame_samples, heard.size() - at);
      canceller->played(std::span(played).subspan(at, size));
      const auto frame = canceller->heard(std::span(heard).subspan(at, size));
      made.insert(made.end(), frame.begin(), frame.end());
    }
    return made;
  }
};

double level_between(const Sound& sound, std::int64_t begin, std::int64_t end) {
  return test::level_of(std::span(sound).subspan(
      test::samples_in(begin), test::samples_in(end - begin)));
}

TEST_F(EchoCancellerTest, TakesOutTheEcho) {
  const auto played = test::speech_like(1, 12'000, -20);
  const auto echo = echo_of(played, 60);
  const auto rest = enhanced(played, echo);
  const auto reduction =
      level_between(echo, 6'000, 12'000) - level_between(rest, 6'000, 12'000);
  RecordProperty("echo_reduction_dB", static_cast<int>(reduction));
  EXPECT_GE(reduction, 25);
}

TEST_F(EchoCancellerTest, LeavesSpeechWhilePlaying) {
  const auto played = test::speech_like(2, 12'000, -26);
  auto heard = echo_of(played, 60);
  test::add(heard, test::speech_like(3, 2'000, -20), test::samples_in(8'000));
  const auto rest = enhanced(played, heard);
  EXPECT_GE(level_between(rest, 8'000, 10'000),
            level_between(heard, 8'000, 10'000) - 8);
}

TEST_F(EchoCancellerTest, TakesNoiseOutOnRequest) {
  const auto noise = test::pink_noise(5, 6'000, -30);
  auto canceller = EchoCanceller::make({.noise_suppression = true});
  Sound rest;
  for (std::size_t at = 0; at < noise.size(); at += frame_samples) {
    const auto frame =
        canceller->heard(std::span(noise).subspan(at, frame_samples));
    rest.insert(rest.end(), frame.begin(), frame.end());
  }
  EXPECT_LE(level_between(rest, 3'000, 6'000), -34);
}

} // namespace
} // namespace parlour::adapters
