#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/alsa/device_trial.hpp"
#include "tests/adapters/audio/alsa/virtual_device.hpp"
#include "tests/adapters/audio/tones.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

TEST(DeviceTrialTest, SaysHowLoudItIs) {
  const test::VirtualDevice device({48'000, 2});
  std::vector<Sample> sound(24'000);
  const auto tone = test::tone(400, 0.1, 24'000, 48'000);
  sound.insert(sound.end(), tone.begin(), tone.end());
  device.captures(sound, DeviceSamples::s16, 2);
  std::vector<double> levels;
  const auto heard = try_microphone(
      "dev", Milliseconds(1'000),
      [&](const LevelMeter& level) { levels.push_back(level.level()); },
      test::VirtualDevice::limits());
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->samples(), 96'000u);
  ASSERT_EQ(levels.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(levels[i], i < 5 ? LevelMeter::floor : -23, 0.1) << i;
  EXPECT_NEAR(heard->level(), -26, 0.1);
}

TEST(DeviceTrialTest, PlaysATone) {
  const test::VirtualDevice device;
  ASSERT_TRUE(
      try_speaker("dev", Milliseconds(1'000), test::VirtualDevice::limits()));
  auto played = device.played();
  ASSERT_GE(played.size(), 16'000u);
  played.resize(16'000);
  EXPECT_GT(test::level_of(played, 440), 0.05);
  LevelMeter meter;
  meter.add(played);
  EXPECT_NEAR(meter.peak(), -20, 0.5);
}

TEST(DeviceTrialTest, PlaysSoundOfAnotherRate) {
  const test::VirtualDevice device({48'000, 2});
  const auto sound = test::tone(440, 0.5, 8'000);
  ASSERT_TRUE(play_sound("dev", sound, test::VirtualDevice::limits()));
  auto played = device.played();
  ASSERT_GE(played.size(), 48'000u); // half a second, of both channels
  std::vector<Sample> left;
  for (std::size_t i = 0; i < 48'000; i += 2)
    left.push_back(played[i]);
  EXPECT_GT(test::level_of(left, 440, 48'000), 0.4);
  EXPECT_THAT(
      play_sound("none", sound, test::VirtualDevice::limits()).error().message,
      HasSubstr("there is no such sound device"));
}

TEST(DeviceTrialTest, SaysWhyItCannot) {
  const test::VirtualDevice device({16'000, 1, "S16_LE", 10, "unplug@1600"});
  const auto no_level = [](const LevelMeter&) {};
  EXPECT_THAT(try_microphone("none", Milliseconds(100), no_level,
                             test::VirtualDevice::limits())
                  .error()
                  .message,
              HasSubstr("there is no such sound device"));
  EXPECT_THAT(try_microphone("dev", Milliseconds(1'000), no_level,
                             test::VirtualDevice::limits())
                  .error()
                  .message,
              HasSubstr("there is no such sound device"));
  EXPECT_THAT(
      try_speaker("dev", Milliseconds(100), test::VirtualDevice::limits())
          .error()
          .message,
      HasSubstr("there is no such sound device"));
}

} // namespace
} // namespace parlour::adapters
