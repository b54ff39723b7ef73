// libespeak-ng, by itself: one piece of a text.
#include <gtest/gtest.h>

#include "adapters/tts/espeak_synthesizer.hpp"
#include "tests/adapters/tts/heard_sink.hpp"

namespace parlour::adapters::tts {
namespace {

class EspeakSynthesizerTest : public testing::Test {
protected:
  void SetUp() override {
    if (!made)
      GTEST_SKIP() << made.error().message;
  }
  Expected<std::unique_ptr<Synthesizer>> made = make_espeak_synthesizer();
};

TEST_F(EspeakSynthesizerTest, SpeaksAPieceAndTellsItsWords) {
  test::HeardSink sink;
  VoiceSettings settings;
  settings.voice = "en-us";
  ASSERT_TRUE(
      (*made)->speak(speakable_words("Good morning"), true, settings, sink));
  EXPECT_GT(sink.samples, 0u);
  EXPECT_GE(sink.rate, 8'000);
  EXPECT_EQ(sink.words, (std::set<std::size_t>{0, 1}));
}

TEST_F(EspeakSynthesizerTest, KnowsItsVoices) {
  EXPECT_TRUE((*made)->check_voice("en-us"));
  EXPECT_EQ((*made)->check_voice("nobody").error().kind, ErrorKind::settings);
}

} // namespace
} // namespace parlour::adapters::tts
