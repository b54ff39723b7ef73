#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/file_microphone.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/audio/tones.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class FileMicrophoneTest : public testing::Test {
protected:
  FileMicrophoneTest() {
    host.application = folder.path().string();
    host.time.set(1'000'000);
    write(test::tone(400, 0.5, 1'600)); // 100 ms
  }

  void write(const std::vector<Sample>& samples, const PcmFormat& format = {}) {
    ASSERT_TRUE(SoundFileWriter::create(folder.path() / "a.wav", format)
                    ->write(samples));
  }
  Expected<void> start(Options options = {}) {
    options.emplace("file", "a.wav");
    options.emplace("silence", "0s");
    microphone = file_microphone_factory().create();
    return microphone->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {}) {
    microphone->receive(test::message(std::move(command), std::move(params)));
  }
  // Names and positions of the events; the audio goes to `heard`.
  std::vector<std::string> events() {
    std::vector<std::string> texts;
    for (const auto& event : std::exchange(host.events, {})) {
      auto text = event.command;
      if (event.command == "BufferFull") {
        const auto samples = speech_samples(event.params[0]);
        if (samples)
          heard.insert(heard.end(), samples->begin(), samples->end());
        else
          text += event.params[0].if_binary()->format;
        EXPECT_TRUE(event.session.empty());
      }
      for (const auto& param : event.params)
        if (!param.if_binary())
          text += " " + param.text();
      texts.push_back(std::move(text));
    }
    return texts;
  }

  test::TemporaryFolder folder;
  test::FakePluginHost host;
  std::unique_ptr<IPlugin> microphone;
  std::vector<Sample> heard;
};

TEST_F(FileMicrophoneTest, ConformsToItsRole) {
  TestOptions options;
  options.options = {{"file", "a.wav"}};
  options.application_folder = folder.path().string();
  options.data_folder = folder.path().string();
  EXPECT_THAT(conformance_errors(file_microphone_factory(), options),
              IsEmpty());
}

TEST_F(FileMicrophoneTest, HearsTheFileInItsTime) {
  ASSERT_TRUE(start());
  EXPECT_EQ(host.pending(), 0u);
  send("start_mic");
  EXPECT_THAT(events(), ElementsAre("Started"));
  host.advance(Milliseconds(19));
  EXPECT_THAT(events(), IsEmpty());
  host.advance(Milliseconds(1));
  EXPECT_THAT(events(), ElementsAre("BufferFull 0"));
  host.advance(Milliseconds(80));
  EXPECT_THAT(events(), ElementsAre("BufferFull 20", "BufferFull 40",
                                    "BufferFull 60", "BufferFull 80"));
  EXPECT_EQ(heard, test::tone(400, 0.5, 1'600));
  host.advance(Milliseconds(20));
  EXPECT_THAT(events(), ElementsAre("FileEnded 100"));
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(FileMicrophoneTest, SilenceFollowsTheFile) {
  ASSERT_TRUE(start({{"silence", "200ms"}}));
  send("start_mic");
  host.advance(Milliseconds(1'000));
  EXPECT_THAT(events(), testing::Contains("FileEnded 300"));
  EXPECT_EQ(heard.size(), 4'800u);
}

TEST_F(FileMicrophoneTest, IsAsFastAsItIsTold) {
  ASSERT_TRUE(start({{"pace", "10"}}));
  send("start_mic");
  host.advance(Milliseconds(9));
  EXPECT_EQ(events().size(), 5u);
  host.advance(Milliseconds(3));
  EXPECT_THAT(events(), ElementsAre("BufferFull 80", "FileEnded 100"));
}

TEST_F(FileMicrophoneTest, PaceZeroIsFastButBounded) {
  write(test::tone(400, 0.5, 160'000));
  ASSERT_TRUE(start({{"pace", "0"}}));
  send("start_mic");
  host.advance(Milliseconds(100));
  EXPECT_NEAR(static_cast<double>(events().size()), 80, 2);
}

TEST_F(FileMicrophoneTest, GoesOnWhereItWasStopped) {
  ASSERT_TRUE(start());
  send("start_mic");
  host.advance(Milliseconds(45));
  send("stop_mic");
  host.advance(Milliseconds(1'000));
  EXPECT_THAT(events(), ElementsAre("Started", "BufferFull 0", "BufferFull 20",
                                    "Stopped"));
  EXPECT_EQ(host.pending(), 0u);
  send("start_mic");
  host.advance(Milliseconds(1'000));
  EXPECT_THAT(events(), ElementsAre("Started", "BufferFull 0", "BufferFull 20",
                                    "BufferFull 40", "FileEnded 60"));
  EXPECT_EQ(heard, test::tone(400, 0.5, 1'600));
  send("start_mic");
  host.advance(Milliseconds(1'000));
  EXPECT_EQ(events().size(), 7u); // the file again
}

TEST_F(FileMicrophoneTest, IsStartedOnce) {
  ASSERT_TRUE(start());
  send("start_mic");
  send("start_mic");
  host.advance(Milliseconds(20));
  EXPECT_THAT(events(), ElementsAre("Started", "Started", "BufferFull 0"));
}

TEST_F(FileMicrophoneTest, ComesAgainUntilItIsStopped) {
  ASSERT_TRUE(start({{"loop", "true"}}));
  send("start_mic");
  host.advance(Milliseconds(10'000));
  EXPECT_EQ(events().size(), 501u);
  microphone->stop();
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(FileMicrophoneTest, AnyFormatOfFile) {
  std::vector<Sample> stereo;
  for (const auto sample : test::tone(1'000, 0.5, 44'100, 44'100))
    stereo.insert(stereo.end(), {sample, sample});
  write(stereo, {44'100, 2});
  ASSERT_TRUE(start());
  send("start_mic");
  host.advance(Milliseconds(2'000));
  events();
  ASSERT_GE(heard.size(), 16'000u);
  EXPECT_NEAR(test::level_of(std::span(heard).first(15'680), 1'000), 0.5, 0.01);
}

TEST_F(FileMicrophoneTest, AnotherFormatIfItIsWanted) {
  ASSERT_TRUE(start());
  send("SetFormat", {8'000, 2});
  send("start_mic");
  host.advance(Milliseconds(20));
  EXPECT_THAT(
      events(),
      ElementsAre("Started", "BufferFullpcm_s16le;rate=8000;channels=2 0"));
  send("SetFormat", {16'000, 1});
  EXPECT_THAT(events(), ElementsAre(HasSubstr("while the microphone is")));
  send("stop_mic");
  events();
  send("SetFormat", {1, 1});
  EXPECT_THAT(events(), ElementsAre(HasSubstr("8000 to 48000")));
}

TEST_F(FileMicrophoneTest, SaysWhatIsWrongWithItsOptions) {
  EXPECT_THAT(to_string(start({{"file", "no.wav"}}).error()),
              HasSubstr("no.wav: this file cannot be read"));
  EXPECT_THAT(start({{"file", ""}}).error().message,
              HasSubstr("which file is heard"));
  EXPECT_THAT(start({{"file", "../a.wav"}}).error().message,
              HasSubstr("leaves its folder"));
  EXPECT_THAT(start({{"pace", "99"}}).error().message, HasSubstr("pace"));
  EXPECT_THAT(start({{"silence", "2h"}}).error().message, HasSubstr("to 1h"));
}

TEST_F(FileMicrophoneTest, AFileOfTheCommandLineMayBeAnywhere) {
  const auto file = folder.path() / "a.wav";
  host.application = "/nowhere";
  microphone = file_microphone_factory(file).create();
  ASSERT_TRUE(microphone->start(host, {{"file", "other.wav"}}));
  send("start_mic");
  host.advance(Milliseconds(100));
  events();
  EXPECT_EQ(heard, test::tone(400, 0.5, 1'600));
}

} // namespace
} // namespace parlour::adapters
