#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/file_speaker.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/audio/tones.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class FileSpeakerTest : public testing::Test {
protected:
  FileSpeakerTest() {
    host.data = folder.path().string();
    host.time.set(1'000'000);
  }

  Expected<void> start(const Options& options = {}) {
    speaker = file_speaker_factory().create();
    return speaker->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {}) {
    speaker->receive(test::message(std::move(command), std::move(params)));
  }
  void play(int utterance, const std::vector<Sample>& samples) {
    send("Play", {pcm_value(samples), utterance});
  }
  // All events but Playing, whose audio goes to `playing`.
  std::vector<std::string> events() {
    std::vector<std::string> texts;
    for (auto& event : std::exchange(host.events, {}))
      if (event.command == "Playing") {
        const auto samples = *speech_samples(event.params[0]);
        playing.insert(playing.end(), samples.begin(), samples.end());
        positions.push_back(event.params[1].integer_or(-1));
      } else {
        texts.push_back(to_string(event).substr(1));
      }
    return texts;
  }
  std::vector<Sample> written(const std::string& name = "speaker.wav") const {
    auto reader = SoundFileReader::open(folder.path() / name);
    EXPECT_TRUE(reader);
    std::vector<Sample> samples(1'000'000);
    samples.resize(reader->read(samples));
    return samples;
  }

  test::TemporaryFolder folder;
  test::FakePluginHost host;
  std::unique_ptr<IPlugin> speaker;
  std::vector<Sample> playing;
  std::vector<std::int64_t> positions;
};

TEST_F(FileSpeakerTest, ConformsToItsRole) {
  TestOptions options;
  options.application_folder = folder.path().string();
  options.data_folder = folder.path().string();
  EXPECT_THAT(conformance_errors(file_speaker_factory(), options), IsEmpty());
}

TEST_F(FileSpeakerTest, WritesWhatWouldBeHeardInItsTime) {
  ASSERT_TRUE(start());
  const auto tone = test::tone(400, 0.5, 1'600); // 100 ms
  play(1, tone);
  send("Finish", {1});
  EXPECT_THAT(events(), IsEmpty());
  host.advance(Milliseconds(20));
  EXPECT_THAT(events(), ElementsAre("Started(1)"));
  host.advance(Milliseconds(79));
  EXPECT_THAT(events(), IsEmpty());
  host.advance(Milliseconds(1));
  EXPECT_THAT(events(), ElementsAre("Finished(1, 100, false, unknown)"));
  EXPECT_EQ(playing, tone);
  EXPECT_THAT(positions, ElementsAre(0, 20, 40, 60, 80));
  EXPECT_EQ(written(), tone);
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(FileSpeakerTest, StopFadesOutWithin60MsAndSaysWhatWasSaid) {
  ASSERT_TRUE(start());
  send("Mark", {1, "good", 0});
  send("Mark", {1, "morning", 60});
  send("Mark", {1, "sir", 200});
  play(1, std::vector<Sample>(16'000, 10'000));
  send("Finish", {1});
  host.advance(Milliseconds(100));
  events();
  send("Stop", {1});
  host.advance(Milliseconds(60));
  EXPECT_THAT(events(), ElementsAre("Finished(1, 120, true, good)"));
  const auto heard = written();
  EXPECT_EQ(heard.size(), 1'920u);
  EXPECT_LT(heard.back(), 50);
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(FileSpeakerTest, AnswersTheMessageThatFinishes) {
  ASSERT_TRUE(start());
  play(1, std::vector<Sample>(160));
  speaker->receive(test::message("Finish", {1}, "s1", 99));
  host.advance(Milliseconds(20));
  ASSERT_FALSE(host.events.empty());
  const auto finished =
      std::ranges::find(host.events, "Finished", &Message::command);
  ASSERT_NE(finished, host.events.end());
  EXPECT_EQ(finished->correlation, 99u);
  EXPECT_EQ(finished->session, "s1");
}

TEST_F(FileSpeakerTest, SilenceIsWrittenIfItIsWanted) {
  for (const auto* silence : {"0s", "300ms", "10s"}) {
    ASSERT_TRUE(start({{"silence", silence}}));
    for (const int utterance : {1, 2}) {
      play(utterance, std::vector<Sample>(1'600, 9));
      send("Finish", {utterance});
      host.advance(Milliseconds(1'100));
    }
    speaker->stop();
    // 100 ms, and of the second that follows as much as is wanted.
    const auto between = static_cast<std::size_t>(
        std::min<std::int64_t>(1'000, parse_duration(silence)->count()));
    const auto heard = written();
    ASSERT_EQ(heard.size(), (200 + between) * 16) << silence;
    EXPECT_EQ(heard[1'599], 9);
    EXPECT_EQ(heard[1'600], between ? 0 : 9);
    EXPECT_EQ(heard[1'600 + between * 16], 9);
  }
}

TEST_F(FileSpeakerTest, PlaysFaster) {
  ASSERT_TRUE(start({{"pace", "10"}}));
  play(1, std::vector<Sample>(16'000, 9));
  send("Finish", {1});
  host.advance(Milliseconds(100));
  EXPECT_THAT(events(),
              ElementsAre("Started(1)", "Finished(1, 1000, false, unknown)"));
}

TEST_F(FileSpeakerTest, AnyRateOfFile) {
  ASSERT_TRUE(start({{"rate", "44100"}, {"file", "voice/a.flac"}}));
  play(1, test::tone(500, 0.5, 16'000));
  send("Finish", {1});
  host.advance(Milliseconds(1'000));
  speaker->stop();
  const auto heard = written("voice/a.flac");
  EXPECT_NEAR(static_cast<double>(heard.size()), 44'100, 5);
  EXPECT_NEAR(test::level_of(heard, 500, 44'100), 0.5, 0.01);
}

TEST_F(FileSpeakerTest, RefusesWhatItCannotPlay) {
  ASSERT_TRUE(start());
  send("Play", {"hello", 1});
  send("Play", {pcm_value({}, {44'100, 2}), 1});
  EXPECT_THAT(events(), ElementsAre(HasSubstr("Failed(this is no audio"),
                                    HasSubstr("16,000 samples a second")));
  for (int i = 0; i < 31; ++i)
    play(1, std::vector<Sample>(160'000));
  EXPECT_THAT(events(), ElementsAre(HasSubstr("wait to be played")));
  speaker->stop();
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(FileSpeakerTest, SaysWhatIsWrongWithItsOptions) {
  EXPECT_THAT(start({{"file", "../a.wav"}}).error().message,
              HasSubstr("leaves its folder"));
  EXPECT_THAT(start({{"pace", "fast"}}).error().message, HasSubstr("pace"));
  EXPECT_THAT(start({{"rate", "1"}}).error().message, HasSubstr("rate"));
  EXPECT_THAT(start({{"silence", "9h"}}).error().message, HasSubstr("1h"));
  std::filesystem::create_directory(folder.path() / "taken.wav");
  EXPECT_EQ(start({{"file", "taken.wav"}}).error().kind, ErrorKind::file);
}

TEST_F(FileSpeakerTest, AFileOfTheCommandLineMayBeAnywhere) {
  host.data = "/nowhere";
  speaker = file_speaker_factory(folder.path() / "out.wav").create();
  ASSERT_TRUE(speaker->start(host, {}));
  play(1, std::vector<Sample>(320, 9));
  send("Finish", {1});
  host.advance(Milliseconds(20));
  EXPECT_EQ(written("out.wav").size(), 320u);
}

TEST_F(FileSpeakerTest, RefusesADevice) {
  std::filesystem::create_symlink("/dev/full", folder.path() / "full.wav");
  EXPECT_FALSE(start({{"file", "full.wav"}}));
}

} // namespace
} // namespace parlour::adapters
