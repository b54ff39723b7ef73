#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/wyoming/audio_events.hpp"

namespace parlour::adapters::wyoming {
namespace {

TEST(WyomingAudio, says_its_format) {
  EXPECT_EQ(audio_start().data,
            (nlohmann::json{{"rate", 16'000}, {"width", 2}, {"channels", 1}}));
  const auto chunk = audio_chunk("ab", 20);
  EXPECT_EQ(chunk.data["timestamp"], 20);
  EXPECT_EQ(chunk.data["rate"], 16'000);
  EXPECT_EQ(chunk.payload, "ab");
  EXPECT_EQ(audio_stop(40).data["timestamp"], 40);
}

TEST(WyomingAudio, keeps_samples) {
  const std::vector<Sample> samples = {1, -1, 32'767};
  EXPECT_EQ(samples_of(bytes_of(samples)), samples);
  EXPECT_THAT(samples_of("a"), testing::IsEmpty());
  EXPECT_EQ(duration_of(std::string(640, '\0')), 20);
}

TEST(WyomingAudio, trims_texts) {
  EXPECT_EQ(trimmed(" to be \n"), "to be");
  EXPECT_EQ(trimmed(" \n"), "");
}

} // namespace
} // namespace parlour::adapters::wyoming
