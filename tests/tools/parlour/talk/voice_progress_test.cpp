#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"
#include "tools/parlour/talk/voice_progress.hpp"

namespace parlour::tools {
namespace {

using adapters::Sample;
using testing::StartsWith;

class VoiceProgressTest : public testing::Test {
protected:
  std::optional<std::string> take(const std::string& source,
                                  const std::string& command,
                                  std::vector<Value> params = {}) {
    Message message;
    message.source = source;
    message.command = command;
    message.params = std::move(params);
    return progress.take(message);
  }
  // 20 ms of sound that is as loud as that.
  std::optional<std::string> sound(Sample level) {
    std::vector<Sample> samples(adapters::frame_samples, level);
    for (std::size_t i = 0; i < samples.size(); i += 2)
      samples[i] = static_cast<Sample>(-level);
    return take("Ear", "Process", {adapters::pcm_value(samples), 0});
  }
  std::string doing() const {
    const auto line = progress.line();
    return line.substr(0, line.find("  "));
  }

  VoiceProgress progress{{{"Ear", "Microphone"},
                          {"Turns", "Endpointer"},
                          {"Text", "ASR"},
                          {"Mouth", "Speaker"}}};
};

TEST_F(VoiceProgressTest, SaysWhatIsDone) {
  EXPECT_EQ(doing(), "loading the recogniser");
  EXPECT_THAT(sound(0).value_or(""), StartsWith("listening"));
  EXPECT_THAT(take("Turns", "TurnStarted", {100}).value_or(""),
              StartsWith("hearing you"));
  take("Turns", "Finish");
  EXPECT_EQ(doing(), "thinking");
  EXPECT_EQ(take("Turns", "TurnEnded", {900}), std::nullopt);
  take("Text", "RecognitionResult", {"hello"});
  EXPECT_EQ(doing(), "thinking");
  take("Mouth", "RobotStarted", {1});
  EXPECT_EQ(doing(), "speaking");
  take("Mouth", "RobotFinished", {1});
  EXPECT_EQ(doing(), "listening");
  EXPECT_EQ(take("Somebody", "TurnStarted", {0}), std::nullopt);
}

TEST_F(VoiceProgressTest, GoesBackWhereNothingWasSaid) {
  take("Turns", "TurnStarted", {100});
  take("Turns", "TurnEnded", {900});
  take("Text", "Rejected", {"a noise"});
  EXPECT_EQ(doing(), "listening");
  take("Turns", "TurnStarted", {100});
  take("Turns", "TurnDropped", {900});
  EXPECT_EQ(doing(), "listening");
}

// Whoever interrupts the robot is heard, also when it falls silent then.
TEST_F(VoiceProgressTest, HearsWhoInterrupts) {
  take("Mouth", "Started", {1});
  take("Turns", "TurnStarted", {100});
  take("Mouth", "Finished", {1});
  EXPECT_EQ(doing(), "hearing you");
}

TEST_F(VoiceProgressTest, MaySleep) {
  take("Turns", "FellAsleep", {100});
  EXPECT_EQ(doing(), "asleep");
  sound(0);
  EXPECT_EQ(doing(), "asleep");
  take("Turns", "Woken", {900});
  EXPECT_EQ(doing(), "listening");
}

TEST(SleepingVoiceProgressTest, SleepsAtFirst) {
  VoiceProgress progress({{"Ear", "Microphone"}}, true);
  Message sound;
  sound.source = "Ear";
  sound.command = "BufferFull";
  sound.params = {adapters::pcm_value(std::vector<Sample>(320)), 0};
  EXPECT_THAT(progress.take(sound).value_or(""), StartsWith("asleep"));
}

TEST_F(VoiceProgressTest, MissesTheMicrophone) {
  sound(0);
  take("Ear", "Failed", {"it is gone"});
  EXPECT_EQ(progress.line(), "no microphone; waiting for it");
  sound(0);
  EXPECT_EQ(doing(), "listening");
}

TEST_F(VoiceProgressTest, ShowsHowLoudItIs) {
  sound(0);
  int drawn = 0;
  for (int i = 1; i < 50; ++i)
    drawn += sound(3'277).has_value();
  EXPECT_EQ(drawn, 5); // of a second
  EXPECT_EQ(progress.line(), "listening    [#############       ]  -20 dB");
  for (int i = 0; i < 10; ++i)
    sound(32'767);
  EXPECT_EQ(progress.line(),
            "listening    [####################]    0 dB too loud");
  for (int i = 0; i < 10; ++i)
    sound(0);
  EXPECT_EQ(progress.line(), "listening    [                    ] -100 dB");
}

} // namespace
} // namespace parlour::tools
