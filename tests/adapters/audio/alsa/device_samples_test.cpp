#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "adapters/audio/alsa/device_samples.hpp"

namespace parlour::adapters {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of_numbers(std::initializer_list<int> numbers) {
  Bytes bytes;
  for (const auto number : numbers)
    bytes.push_back(static_cast<std::byte>(number));
  return bytes;
}

TEST(DeviceSamplesTest, EachKindKeepsSamples) {
  const std::vector<Sample> samples = {0, 1, -1, 12'345, 32'767, -32'768};
  for (const auto kind :
       {DeviceSamples::s16, DeviceSamples::s32, DeviceSamples::s24,
        DeviceSamples::s24_3, DeviceSamples::float32}) {
    Bytes bytes;
    append_bytes(kind, samples, bytes);
    EXPECT_EQ(bytes.size(), samples.size() * bytes_of(kind));
    std::vector<Sample> back;
    append_samples(kind, bytes, back);
    EXPECT_EQ(back, samples) << static_cast<int>(kind);
  }
}

TEST(DeviceSamplesTest, KnowsHowTheyLie) {
  Bytes bytes;
  append_bytes(DeviceSamples::s16, std::vector<Sample>{0x1234}, bytes);
  EXPECT_EQ(bytes, bytes_of_numbers({0x34, 0x12}));
  bytes.clear();
  append_bytes(DeviceSamples::s24_3, std::vector<Sample>{0x1234}, bytes);
  EXPECT_EQ(bytes, bytes_of_numbers({0, 0x34, 0x12}));
  bytes.clear();
  append_bytes(DeviceSamples::s24, std::vector<Sample>{-2}, bytes);
  EXPECT_EQ(bytes, bytes_of_numbers({0, 0xfe, 0xff, 0xff}));
  bytes.clear();
  append_bytes(DeviceSamples::s32, std::vector<Sample>{0x1234}, bytes);
  EXPECT_EQ(bytes, bytes_of_numbers({0, 0, 0x34, 0x12}));
}

// Some devices leave rubbish in the byte that 24 bit do not use.
TEST(DeviceSamplesTest, IgnoresTheUnusedByte) {
  std::vector<Sample> samples;
  append_samples(DeviceSamples::s24, bytes_of_numbers({0, 0x34, 0x12, 0xaa}),
                 samples);
  EXPECT_EQ(samples, std::vector<Sample>{0x1234});
}

TEST(DeviceSamplesTest, FloatingPointMayBeAnything) {
  Bytes bytes(4 * 4);
  const float values[] = {2, -2, std::nanf(""), INFINITY};
  std::memcpy(bytes.data(), values, sizeof values);
  std::vector<Sample> samples;
  append_samples(DeviceSamples::float32, bytes, samples);
  EXPECT_EQ(samples, (std::vector<Sample>{32'767, -32'768, 0, 32'767}));
}

TEST(DeviceSamplesTest, HalfASampleIsLeftOut) {
  std::vector<Sample> samples;
  append_samples(DeviceSamples::s32, Bytes(7), samples);
  EXPECT_EQ(samples.size(), 1u);
}

} // namespace
} // namespace parlour::adapters
