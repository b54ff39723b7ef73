// flite, by itself: one piece of a text.
#include <gtest/gtest.h>

#include "adapters/tts/flite_synthesizer.hpp"
#include "tests/adapters/tts/heard_sink.hpp"

namespace parlour::adapters::tts {
namespace {

class FliteSynthesizerTest : public testing::Test {
protected:
  void SetUp() override {
    if (!made)
      GTEST_SKIP() << made.error().message;
  }
  Expected<std::unique_ptr<Synthesizer>> made = make_flite_synthesizer();
};

TEST_F(FliteSynthesizerTest, SpeaksAPieceAndTellsItsWords) {
  test::HeardSink sink;
  VoiceSettings settings;
  settings.voice = "slt";
  ASSERT_TRUE(
      (*made)->speak(speakable_words("Good morning"), true, settings, sink));
  EXPECT_GT(sink.samples, 0u);
  EXPECT_GE(sink.rate, 8'000);
  EXPECT_EQ(sink.words, (std::set<std::size_t>{0, 1}));
}

TEST_F(FliteSynthesizerTest, KnowsItsVoices) {
  EXPECT_TRUE((*made)->check_voice("slt"));
  EXPECT_EQ((*made)->check_voice("nobody").error().kind, ErrorKind::settings);
}

} // namespace
} // namespace parlour::adapters::tts
