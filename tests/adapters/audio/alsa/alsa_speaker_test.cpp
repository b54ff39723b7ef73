#include "adapters/audio/alsa/alsa_speaker.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/audio/alsa/alsa_fixture.hpp"
#include "tests/adapters/audio/tones.hpp"

namespace parlour::adapters {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AlsaSpeakerTest : public test::AlsaTest {
protected:
  Expected<void>
  start(const std::string& name = "dev",
        const StreamLimits& limits = test::VirtualDevice::limits()) {
    return AlsaTest::start(alsa_speaker_factory(limits), name);
  }
  void play(int utterance, const std::vector<Sample>& samples) {
    send("Play", {pcm_value(samples), utterance});
  }
  bool take_audio(const Message& event) override {
    if (event.command != "Playing")
      return false;
    const auto samples = frame_of(event.params[0]);
    playing.insert(playing.end(), samples.begin(), samples.end());
    return true;
  }
  // Without the silence around them.
  static std::vector<Sample> sounding(std::vector<Sample> samples) {
    while (!samples.empty() && samples.back() == 0)
      samples.pop_back();
    const auto first = std::ranges::find_if(
        samples, [](Sample sample) { return sample != 0; });
    samples.erase(samples.begin(), first);
    return samples;
  }

  std::vector<Sample> playing;
};

TEST_F(AlsaSpeakerTest, ConformsToItsRole) {
  device.emplace();
  TestOptions options;
  options.options = {{"device", "dev"}};
  EXPECT_THAT(conformance_errors(alsa_speaker_factory(), options), IsEmpty());
}

TEST_F(AlsaSpeakerTest, PlaysAndSaysWhatWasPlayed) {
  ASSERT_TRUE(start());
  auto tone = test::tone(440, 0.5, 16'000);
  tone.front() = tone.back() = 1; // so that its ends are no silence
  send("Mark", {1, "hello", 0});
  play(1, tone);
  send("Finish", {1});
  ASSERT_TRUE(gets("Finished"));
  EXPECT_THAT(events,
              ElementsAre("Started(1)", "Finished(1, 1000, false, hello)"));
  EXPECT_EQ(sounding(device->played()), tone);
  EXPECT_EQ(sounding(playing), tone);
}

// Two utterances with a pause between them, in which the device rests.
TEST_F(AlsaSpeakerTest, PlaysAgainAfterARest) {
  ASSERT_TRUE(start());
  for (const int utterance : {1, 2}) {
    play(utterance, std::vector<Sample>(3'200, 9));
    send("Finish", {utterance});
    ASSERT_TRUE(gets("Finished(" + std::to_string(utterance)));
    host.wait([] { return false; }, Milliseconds(100)); // a second of its own
  }
  EXPECT_EQ(std::ranges::count(device->played(), Sample{9}), 6'400);
}

TEST_F(AlsaSpeakerTest, AnyFormatOfDevice) {
  use({44'100, 2, "S32_LE"});
  ASSERT_TRUE(start());
  play(1, test::tone(1'000, 0.5, 16'000));
  send("Finish", {1});
  ASSERT_TRUE(gets("Finished(1, 1000"));
  const auto samples = device->played(DeviceSamples::s32);
  std::vector<Sample> left;
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    ASSERT_EQ(samples[i], samples[i + 1]);
    left.push_back(samples[i]);
  }
  left = sounding(left);
  ASSERT_GT(left.size(), 43'000u);
  EXPECT_NEAR(
      test::level_of(std::span(left).subspan(2'205, 39'690), 1'000, 44'100),
      0.5, 0.01);
}

// Counted in samples of the device: it stands still after 200 ms, and the
// utterance is stopped at that moment.
TEST_F(AlsaSpeakerTest, IsSilentWithin60MsOfBeingStopped) {
  use({16'000, 1, "S16_LE", 10, "block@3200"});
  device->block();
  ASSERT_TRUE(start());
  play(7, std::vector<Sample>(320'000, 10'000)); // a mark alone is silence
  send("Mark", {7, "one", 0});
  send("Mark", {7, "two", 60'000});
  wait_until_gone(true);
  send("Stop", {7});
  device->unblock();
  ASSERT_TRUE(gets("Finished(7, "));
  EXPECT_THAT(events.back(), HasSubstr("true, )"));
  const auto heard = sounding(device->played());
  EXPECT_GE(heard.size(), 3'200u);
  EXPECT_LE(heard.size(), 3'200u + 60 * 16);
  EXPECT_LT(heard.back(), 500);
}

TEST_F(AlsaSpeakerTest, GoesOnAfterXrunsAndSuspends) {
  use({16'000, 1, "S16_LE", 10, "xrun@3200 suspend@6400 xrun@6410 xrun@9600"});
  ASSERT_TRUE(start());
  play(1, std::vector<Sample>(16'000, 9));
  send("Finish", {1});
  ASSERT_TRUE(gets("Finished(1, 1000, false"));
  EXPECT_THAT(events, ElementsAre("Started(1)", HasSubstr("Finished")));
  EXPECT_EQ(std::ranges::count(device->played(), Sample{9}), 16'000);
}

TEST_F(AlsaSpeakerTest, UnpluggedAndPutBack) {
  use({16'000, 1, "S16_LE", 10, "unplug@8000"});
  ASSERT_TRUE(start());
  send("Mark", {1, "one", 0});
  send("Mark", {1, "two", 200});
  send("Mark", {1, "three", 3'000});
  play(1, std::vector<Sample>(80'000, 9));
  play(2, std::vector<Sample>(80'000, 9));
  send("Finish", {1});
  ASSERT_TRUE(gets("Failed"));
  EXPECT_THAT(events, ElementsAre("Started(1)", HasSubstr("true, one)"),
                                  "Finished(2, 0, true, unknown)",
                                  HasSubstr("there is no such sound device")));
  EXPECT_TRUE(host.wait([&] { return !host.is_available(); }, patience));
  events.clear();
  play(3, std::vector<Sample>(800, 9));
  take();
  EXPECT_THAT(events, ElementsAre(HasSubstr("Failed(the sound device")));
  device->plug_in();
  ASSERT_TRUE(host.wait([&] { return host.is_available(); }, patience));
  play(4, std::vector<Sample>(1'600, 5));
  send("Finish", {4});
  ASSERT_TRUE(gets("Finished(4, 100, false"));
  EXPECT_EQ(std::ranges::count(device->played(), Sample{5}), 1'600);
}

// Put back before anybody is told: the utterance goes on.
TEST_F(AlsaSpeakerTest, AShortOutageOnlyDelays) {
  use({16'000, 1, "S16_LE", 10, "unplug@3200"});
  auto limits = test::VirtualDevice::limits();
  limits.recovery.report_after = patience;
  ASSERT_TRUE(start("dev", limits));
  play(1, std::vector<Sample>(16'000, 9));
  send("Finish", {1});
  wait_until_gone(true);
  device->plug_in();
  ASSERT_TRUE(gets("Finished(1, 1000, false"));
  EXPECT_THAT(events, ElementsAre("Started(1)", HasSubstr("Finished")));
}

TEST_F(AlsaSpeakerTest, ADeviceThatHangsIsOpenedAnew) {
  use({16'000, 1, "S16_LE", 10, "hang@3200"});
  ASSERT_TRUE(start());
  play(1, std::vector<Sample>(16'000, 9));
  send("Finish", {1});
  ASSERT_TRUE(gets("Finished(1, 1000, false"));
}

TEST_F(AlsaSpeakerTest, StopsWhileTheDriverHangs) {
  use({16'000, 1, "S16_LE", 10, "block@1600"});
  device->block();
  auto limits = test::VirtualDevice::limits();
  limits.patience = Milliseconds(300);
  ASSERT_TRUE(start("dev", limits));
  play(1, std::vector<Sample>(16'000, 9));
  wait_until_gone(true);
  // Commands do not wait for the driver, either.
  play(2, std::vector<Sample>(16'000, 9));
  plugin->stop();
  EXPECT_THAT(host.take_logs(), ElementsAre(HasSubstr("driver hangs")));
  plugin.reset();
  device->unblock();
  wait_until_gone(false);
}

TEST_F(AlsaSpeakerTest, SaysThatThereIsNoSpeaker) {
  const auto started = start("hw:7");
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message, HasSubstr("there is no such sound"));
  EXPECT_THAT(started.error().message, HasSubstr("--speaker FILE.wav"));
}

// ALSA's null device takes everything at once.
TEST_F(AlsaSpeakerTest, ADeviceWithoutPaceIsHeldBack) {
  auto limits = test::VirtualDevice::limits();
  limits.fastest = 10;
  ASSERT_TRUE(start("null", limits));
  const auto begin = std::chrono::steady_clock::now();
  play(1, std::vector<Sample>(160'000, 9));
  send("Finish", {1});
  ASSERT_TRUE(gets("Finished(1, 10000"));
  EXPECT_GT(std::chrono::steady_clock::now() - begin, Milliseconds(700));
}

} // namespace
} // namespace parlour::adapters
