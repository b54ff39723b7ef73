#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/resampler.hpp"
#include "tests/adapters/audio/tones.hpp"

namespace parlour::adapters {
namespace {

using Samples = std::vector<Sample>;

// Converts in pieces of `block` samples of each channel.
Samples convert(const PcmFormat& from, const PcmFormat& to,
                std::span<const Sample> samples, std::size_t block) {
  auto resampler = Resampler::create(from, to);
  EXPECT_TRUE(resampler);
  Samples out;
  block *= static_cast<std::size_t>(from.channels);
  for (; !samples.empty();
       samples = samples.subspan(std::min(block, samples.size())))
    resampler->process(samples.first(std::min(block, samples.size())), out);
  resampler->finish(out);
  return out;
}

// Without its first and last 50 ms, where a tone begins and ends.
std::span<const Sample> inside_of(const Samples& samples, int rate) {
  const auto edge = static_cast<std::size_t>(rate) / 20;
  return std::span(samples).subspan(edge, samples.size() - 2 * edge);
}

class ResamplerRateTest : public testing::TestWithParam<int> {};

TEST_P(ResamplerRateTest, KeepsFrequencyLevelAndLength) {
  const int rate = GetParam();
  const auto second = static_cast<std::size_t>(rate);
  const auto there = convert(
      {rate, 1}, {}, test::tone(1'000, 0.5, second, rate), second / 100);
  EXPECT_NEAR(static_cast<double>(there.size()), speech_rate, 2);
  const auto heard = inside_of(there, speech_rate);
  EXPECT_NEAR(test::decibels(test::level_of(heard, 1'000) / 0.5), 0, 0.1);
  // What is not the tone is far below it.
  const auto all = test::loudness(heard) * std::numbers::sqrt2;
  EXPECT_NEAR(all, test::level_of(heard, 1'000), 0.001);
  const auto back = convert({}, {rate, 1}, there, frame_samples);
  EXPECT_NEAR(static_cast<double>(back.size()), rate, 5);
  EXPECT_NEAR(
      test::decibels(test::level_of(inside_of(back, rate), 1'000, rate) / 0.5),
      0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Rates, ResamplerRateTest,
                         testing::Values(8'000, 11'025, 16'000, 22'050, 32'000,
                                         44'100, 48'000, 96'000, 192'000));

TEST(ResamplerTest, BordersBetweenPiecesCannotBeHeard) {
  const auto tone = test::tone(440, 0.9, 44'100, 44'100);
  const auto whole = convert({44'100, 1}, {}, tone, tone.size());
  for (const std::size_t block : {1U, 7U, 160U, 441U, 4'096U})
    EXPECT_EQ(convert({44'100, 1}, {}, tone, block), whole) << block;
}

// 10 kHz cannot be in 16,000 samples a second; it would come back as 6 kHz.
TEST(ResamplerTest, TakesOutWhatTheOtherRateCannotHave) {
  const auto there =
      convert({48'000, 1}, {}, test::tone(10'000, 0.9, 48'000, 48'000), 480);
  const auto heard = inside_of(there, speech_rate);
  EXPECT_LT(test::decibels(test::loudness(heard)), -80);
}

TEST(ResamplerTest, MixesAndCopiesChannels) {
  const Samples stereo = {100, 300, -32'768, -32'768, 32'767, 32'767, 5, -5};
  EXPECT_EQ(convert({16'000, 2}, {16'000, 1}, stereo, 1),
            (Samples{200, -32'768, 32'767, 0}));
  EXPECT_EQ(convert({16'000, 1}, {16'000, 3}, Samples{7, -7}, 2),
            (Samples{7, 7, 7, -7, -7, -7}));
  EXPECT_EQ(convert({16'000, 2}, {16'000, 2}, stereo, 4), stereo);
}

TEST(ResamplerTest, KeepsChannelsApartIfBothSidesHaveThem) {
  const auto left = test::tone(500, 0.5, 48'000, 48'000);
  Samples stereo;
  for (const auto sample : left)
    stereo.insert(stereo.end(), {sample, 0});
  const auto there = convert({48'000, 2}, {16'000, 2}, stereo, 480);
  Samples heard[2];
  for (std::size_t i = 0; i < there.size(); ++i)
    heard[i % 2].push_back(there[i]);
  EXPECT_NEAR(test::level_of(inside_of(heard[0], speech_rate), 500), 0.5, 0.01);
  EXPECT_EQ(test::loudness(heard[1]), 0);
}

TEST(ResamplerTest, FullScaleDoesNotTurnOver) {
  Samples square;
  for (std::size_t i = 0; i < 48'000; ++i)
    square.push_back(i / 60 % 2 ? 32'767 : -32'768);
  const auto there = convert({48'000, 1}, {}, square, 480);
  // Sample 10 of each half period of 20 is far from its edges.
  for (std::size_t i = 1'010; i < 15'000; i += 20)
    EXPECT_GT(there[i] * (i / 20 % 2 ? 1 : -1), 20'000) << i;
}

TEST(ResamplerTest, BeginsAnewAfterTheEnd) {
  auto resampler = Resampler::create({8'000, 1}, {});
  ASSERT_TRUE(resampler);
  const auto tone = test::tone(300, 0.5, 800, 8'000);
  Samples once;
  resampler->process(tone, once);
  resampler->finish(once);
  Samples twice;
  resampler->process(tone, twice);
  resampler->finish(twice);
  EXPECT_EQ(once, twice);
  EXPECT_NEAR(static_cast<double>(once.size()), 1'600, 2);
}

} // namespace
} // namespace parlour::adapters
