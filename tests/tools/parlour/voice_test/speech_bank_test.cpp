#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/parlour/voice_test/fakes.hpp"
#include "tools/parlour/voice_test/speech_bank.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class SpeechBankTest : public testing::Test {
protected:
  std::string trouble(const std::string& text, const std::string& voice) {
    const auto spoken = bank.speak(text, voice);
    return spoken ? "spoken" : spoken.error().message;
  }

  SpeechBank bank{std::make_shared<test::HummingVoices>()};
};

TEST_F(SpeechBankTest, speaks_a_line_without_silence_and_at_a_level) {
  const auto spoken = bank.speak("hello", "rms");
  ASSERT_TRUE(spoken);
  EXPECT_EQ((*spoken)->size(), adapters::samples_in(1'260));
  EXPECT_NEAR(adapters::speech_level_of(**spoken), SpeechBank::level, 0.1);
}

TEST_F(SpeechBankTest, speaks_a_line_once_for_each_voice) {
  const auto* first = bank.speak("hello", "rms").value();
  EXPECT_EQ(bank.speak("hello", "rms").value(), first);
  EXPECT_NE(bank.speak("hello", "slt").value(), first);
  EXPECT_EQ(bank.find("hello", "rms"), first);
  EXPECT_EQ(bank.find("bye", "rms"), nullptr);
}

TEST_F(SpeechBankTest, says_what_cannot_be_spoken) {
  EXPECT_THAT(trouble("hello", "nobody"), HasSubstr("a voice 'nobody'"));
  EXPECT_EQ(trouble("unspeakable", "rms"),
            "the voice 'rms' cannot say \"unspeakable\": too hard");
  EXPECT_EQ(trouble("unbearable", "rms"),
            "the voice 'rms' cannot say \"unbearable\": it throws 'too much'");
}

} // namespace
} // namespace parlour::tools
