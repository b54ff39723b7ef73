#include "adapters/audio/alsa/alsa_microphone.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/audio/alsa/alsa_fixture.hpp"
#include "tests/adapters/audio/tones.hpp"

namespace parlour::adapters {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AlsaMicrophoneTest : public test::AlsaTest {
protected:
  Expected<void> start(const std::string& name = "dev") {
    return AlsaTest::start(
        alsa_microphone_factory(test::VirtualDevice::limits()), name);
  }
  bool take_audio(const Message& event) override {
    if (event.command != "BufferFull")
      return false;
    const auto samples = frame_of(event.params[0]);
    heard.insert(heard.end(), samples.begin(), samples.end());
    positions.push_back(event.params[1].integer_or(-1));
    return true;
  }
  // Waits until so much was heard, or such an event has come.
  bool hears(std::size_t samples) {
    return host.wait([&] { return take(), heard.size() >= samples; }, patience);
  }

  std::vector<Sample> heard;
  std::vector<std::int64_t> positions;
};

TEST_F(AlsaMicrophoneTest, ConformsToItsRole) {
  device.emplace();
  TestOptions options;
  options.options = {{"device", "dev"}};
  EXPECT_THAT(conformance_errors(alsa_microphone_factory(), options),
              IsEmpty());
}

TEST_F(AlsaMicrophoneTest, HearsWhatTheDeviceCaptures) {
  ASSERT_TRUE(start());
  const auto tone = test::tone(440, 0.5, 16'000);
  device->captures(tone);
  send("start_mic");
  ASSERT_TRUE(hears(tone.size()));
  EXPECT_THAT(events, ElementsAre("Started()"));
  heard.resize(tone.size());
  EXPECT_EQ(heard, tone);
  for (std::size_t i = 0; i < positions.size(); ++i)
    ASSERT_EQ(positions[i], static_cast<std::int64_t>(i) * frame_time);
}

struct DeviceFormat {
  int rate;
  int channels;
  const char* name;
  DeviceSamples kind;
};

class AlsaMicrophoneFormatTest
    : public AlsaMicrophoneTest,
      public testing::WithParamInterface<DeviceFormat> {};

TEST_P(AlsaMicrophoneFormatTest, IsHeard) {
  const auto& format = GetParam();
  use({format.rate, format.channels, format.name});
  ASSERT_TRUE(start());
  device->captures(test::tone(1'000, 0.5, static_cast<std::size_t>(format.rate),
                              format.rate),
                   format.kind, format.channels);
  send("start_mic");
  ASSERT_TRUE(hears(16'000));
  const auto whole = std::span(heard).subspan(320, 15'360);
  EXPECT_NEAR(test::level_of(whole, 1'000), 0.5, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, AlsaMicrophoneFormatTest,
    testing::Values(DeviceFormat{48'000, 2, "S16_LE", DeviceSamples::s16},
                    DeviceFormat{44'100, 1, "S32_LE", DeviceSamples::s32},
                    DeviceFormat{8'000, 1, "S24_LE", DeviceSamples::s24},
                    DeviceFormat{96'000, 4, "S24_3LE", DeviceSamples::s24_3},
                    DeviceFormat{22'050, 2, "FLOAT_LE",
                                 DeviceSamples::float32}));

TEST_F(AlsaMicrophoneTest, IsQuietUnlessItIsStarted) {
  ASSERT_TRUE(start());
  send("start_mic");
  ASSERT_TRUE(hears(320));
  send("stop_mic");
  ASSERT_TRUE(gets("Stopped"));
  take();
  const auto before = heard.size();
  send("start_mic");
  ASSERT_TRUE(hears(before + 320));
  EXPECT_EQ(positions[before / 320], 0);
  EXPECT_EQ(std::ranges::count(events, "Started()"), 2);
}

TEST_F(AlsaMicrophoneTest, AnotherFormatIfItIsWanted) {
  ASSERT_TRUE(start());
  send("SetFormat", {8'000, 2});
  send("start_mic");
  std::string format;
  ASSERT_TRUE(host.wait(
      [&] {
        for (const auto& event : host.take_events())
          if (event.command == "BufferFull")
            format = event.params[0].if_binary()->format;
        return !format.empty();
      },
      patience));
  EXPECT_EQ(format, "pcm_s16le;rate=8000;channels=2");
  send("SetFormat", {16'000, 1});
  ASSERT_TRUE(host.wait(
      [&] {
        return std::ranges::any_of(host.take_events(), [](const auto& event) {
          return event.command == "Failed";
        });
      },
      patience));
}

// Three of each: nobody is told, and no frame is lost, because the device of
// the test keeps what was not read.
TEST_F(AlsaMicrophoneTest, GoesOnAfterXrunsAndSuspends) {
  use({16'000, 1, "S16_LE", 10,
       "xrun@1600 suspend@3200 xrun@3210 suspend@6400 suspend@6410 xrun@8000"});
  ASSERT_TRUE(start());
  send("start_mic");
  ASSERT_TRUE(hears(16'000));
  EXPECT_THAT(events, ElementsAre("Started()"));
  EXPECT_TRUE(std::ranges::is_sorted(positions));
  EXPECT_TRUE(host.is_available());
}

// The device that made a client without a bound spin: each resume succeeds, and
// the next frame is suspended again.
TEST_F(AlsaMicrophoneTest, ADeviceThatAlwaysFailsIsReportedAndTriedRarely) {
  std::string faults;
  for (int i = 0; i < 2'000; ++i)
    faults += (i ? " suspend@" : "suspend@") + std::to_string(i);
  use({16'000, 1, "S16_LE", 10, faults});
  ASSERT_TRUE(start());
  send("start_mic");
  ASSERT_TRUE(gets("Failed"));
  EXPECT_THAT(events, Contains(HasSubstr("it fails again and again")));
  EXPECT_EQ(
      std::ranges::count_if(
          events, [](const auto& one) { return one.starts_with("Failed"); }),
      1);
}

TEST_F(AlsaMicrophoneTest, UnpluggedAndPutBack) {
  use({16'000, 1, "S16_LE", 10, "unplug@8000"});
  ASSERT_TRUE(start());
  send("start_mic");
  ASSERT_TRUE(gets("Failed"));
  EXPECT_THAT(events.back(), HasSubstr("there is no such sound device"));
  EXPECT_TRUE(host.wait([&] { return !host.is_available(); }, patience));
  take();
  const auto before = heard.size();
  send("start_mic");
  take();
  EXPECT_EQ(
      std::ranges::count_if(
          events, [](const auto& one) { return one.starts_with("Failed"); }),
      2);
  device->plug_in();
  EXPECT_TRUE(host.wait([&] { return host.is_available(); }, patience));
  ASSERT_TRUE(hears(before + 3'200));
  EXPECT_TRUE(std::ranges::is_sorted(positions));
  // The time without a microphone counts.
  EXPECT_GT(positions.back(),
            static_cast<std::int64_t>(positions.size()) * frame_time);
}

TEST_F(AlsaMicrophoneTest, ADeviceThatHangsIsOpenedAnew) {
  use({16'000, 1, "S16_LE", 10, "hang@1600"});
  ASSERT_TRUE(start());
  send("start_mic");
  ASSERT_TRUE(hears(3'200));
  EXPECT_THAT(events, ElementsAre("Started()"));
}

TEST_F(AlsaMicrophoneTest, StopsWhileTheDriverHangs) {
  use({16'000, 1, "S16_LE", 10, "block@1600"});
  device->block();
  auto limits = test::VirtualDevice::limits();
  limits.patience = Milliseconds(300);
  plugin = alsa_microphone_factory(limits).create();
  ASSERT_TRUE(plugin->start(host, {{"device", "dev"}}));
  send("start_mic");
  wait_until_gone(true);
  plugin->stop();
  EXPECT_THAT(host.take_logs(), ElementsAre(HasSubstr("driver hangs")));
  plugin.reset();
  device->unblock();
  wait_until_gone(false);
}

TEST_F(AlsaMicrophoneTest, SaysThatThereIsNoMicrophone) {
  const auto started = start("hw:7");
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message,
              HasSubstr("\"hw:7\" cannot be used: there is no such sound"));
  EXPECT_THAT(started.error().message, HasSubstr("--microphone FILE.wav"));
}

// ALSA's null device gives silence as fast as it is asked.
TEST_F(AlsaMicrophoneTest, ADeviceWithoutPaceIsHeldBack) {
  device.emplace();
  auto limits = test::VirtualDevice::limits();
  limits.fastest = 10;
  plugin = alsa_microphone_factory(limits).create();
  ASSERT_TRUE(plugin->start(host, {{"device", "null"}}));
  const auto begin = std::chrono::steady_clock::now();
  send("start_mic");
  ASSERT_TRUE(hears(160'000)); // 10 s
  EXPECT_GT(std::chrono::steady_clock::now() - begin, Milliseconds(700));
}

} // namespace
} // namespace parlour::adapters
