#include <cerrno>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/alsa/alsa_device.hpp"
#include "adapters/loop/wait_until_ready.hpp"
#include "tests/adapters/audio/alsa/virtual_device.hpp"
#include "tests/adapters/audio/tones.hpp"

namespace parlour::adapters {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Samples = std::vector<Sample>;

Expected<AlsaDevice> open(SoundDirection direction,
                          const std::string& name = "dev") {
  return AlsaDevice::open({name, direction, Milliseconds(40)});
}

// Waits until the device may move something.
void wait_for(AlsaDevice& device) {
  auto waited = device.descriptors();
  ASSERT_EQ(wait_until_ready(waited), Waited::ready);
  device.is_ready(waited);
}

TEST(AlsaDeviceTest, SaysThatThereIsNone) {
  const test::VirtualDevice device;
  EXPECT_THAT(open(SoundDirection::capture, "none").error().message,
              AllOf(HasSubstr("\"none\" cannot be used: there is no such"),
                    HasSubstr("FileMicrophone or --microphone FILE.wav")));
  EXPECT_THAT(open(SoundDirection::playback, "none").error().message,
              HasSubstr("FileSpeaker or --speaker FILE.wav"));
}

TEST(AlsaDeviceTest, HasTheFormatOfTheDevice) {
  const test::VirtualDevice device({48'000, 2, "S32_LE"});
  const auto opened = open(SoundDirection::capture);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->format(), (PcmFormat{48'000, 2}));
}

TEST(AlsaDeviceTest, Captures) {
  const test::VirtualDevice device;
  const auto tone = test::tone(440, 0.5, 16'000);
  device.captures(tone);
  auto opened = open(SoundDirection::capture);
  ASSERT_TRUE(opened);
  ASSERT_EQ(opened->prepare(), 0);
  Samples heard;
  while (heard.size() < tone.size()) {
    wait_for(*opened);
    const auto before = heard.size();
    const auto moved = opened->read(heard, 1'000);
    ASSERT_EQ(moved.error, 0);
    ASSERT_EQ(heard.size(), before + moved.samples);
    ASSERT_LE(moved.samples, 1'000u);
  }
  heard.resize(tone.size());
  EXPECT_EQ(heard, tone);
}

TEST(AlsaDeviceTest, PlaysWithAShortQueue) {
  const test::VirtualDevice device;
  auto opened = open(SoundDirection::playback);
  ASSERT_TRUE(opened);
  ASSERT_EQ(opened->prepare(), 0);
  EXPECT_EQ(opened->room().samples, 640u);
  const auto tone = test::tone(440, 0.5, 16'000);
  std::span<const Sample> rest = tone;
  while (!rest.empty()) {
    const auto moved = opened->write(rest);
    ASSERT_EQ(moved.error, 0);
    EXPECT_LE(opened->queued(), 640u);
    rest = rest.subspan(moved.samples);
    wait_for(*opened);
  }
  EXPECT_EQ(device.played(), tone);
}

class AlsaDeviceFaultTest
    : public testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(AlsaDeviceFaultTest, IsReportedInBothDirections) {
  const auto [fault, error] = GetParam();
  for (const auto direction :
       {SoundDirection::capture, SoundDirection::playback}) {
    const test::VirtualDevice device(
        {16'000, 1, "S16_LE", 10, std::string(fault) + "@1600"});
    auto opened = open(direction);
    ASSERT_TRUE(opened);
    ASSERT_EQ(opened->prepare(), 0);
    AlsaDevice::Moved moved;
    std::size_t all = 0;
    Samples samples(16'000);
    while (moved.error == 0) {
      moved = direction == SoundDirection::capture
                  ? opened->read(samples, 1'000)
                  : opened->write(samples);
      all += moved.samples;
      ASSERT_LE(all, 3'000u);
      if (moved.error == 0)
        wait_for(*opened);
    }
    EXPECT_EQ(moved.error, error);
    EXPECT_EQ(device.is_gone(), error == ENODEV);
    EXPECT_EQ(opened->prepare() == 0, error != ENODEV);
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, AlsaDeviceFaultTest,
                         testing::Values(std::pair{"xrun", EPIPE},
                                         std::pair{"suspend", ESTRPIPE},
                                         std::pair{"unplug", ENODEV}));

} // namespace
} // namespace parlour::adapters
