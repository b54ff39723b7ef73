#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/adaptors.hpp"
#include "tools/parlour/speech/synthesis.hpp"

namespace parlour::tools {
namespace {

using adapters::Sample;
using testing::ElementsAre;
using testing::HasSubstr;

// Says each letter as a sample, the later ones after a while.
class LetterTTS : public TTSPlugin {
protected:
  Expected<void> on_start(const Options& options) override {
    if (options.contains("throws"))
      throw std::runtime_error("no voice");
    if (options.contains("broken"))
      return fail(ErrorKind::settings, "it is broken");
    return {};
  }
  void on_speak(const std::string& text, Utterance utterance,
                std::optional<bool>) override {
    if (text == "refuse")
      return refuse("that is no word");
    if (text == "fail")
      return host().failed("the engine has died");
    if (text == "hang")
      return;
    if (text == "throw")
      throw std::runtime_error("no memory");
    if (text == "throw later") {
      host().after(Milliseconds(100), [] { throw std::runtime_error("late"); });
      return;
    }
    if (text == "other rate")
      return fire_audio({"pcm_s16le;rate=8000;channels=1", {}}, utterance);
    next_ = text;
    order_ = current();
    say(utterance);
  }
  void on_stop(std::optional<Utterance>) override {}

private:
  void say(Utterance utterance) {
    as_answer_to(order_, [&] {
      if (next_.empty())
        return fire_finished(utterance);
      const std::vector<Sample> samples{next_.front()};
      fire_audio(*adapters::pcm_value(samples).if_binary(), utterance);
      next_.erase(0, 1);
      host().after(Milliseconds(100), [=, this] { say(utterance); });
    });
  }

  std::string next_;
  Message order_;
};

Expected<std::vector<Sample>> say(const std::string& text,
                                  const Options& options = {}) {
  const PluginFactory factory{{"LetterTTS", {"TTS"}, "says letters"},
                              [] { return std::make_unique<LetterTTS>(); }};
  return synthesize(factory, options, text, Milliseconds(1'000));
}

TEST(SynthesisTest, CollectsWhatIsSaid) {
  const auto samples = say("abc");
  ASSERT_TRUE(samples) << samples.error().message;
  EXPECT_THAT(*samples, ElementsAre('a', 'b', 'c'));
}

TEST(SynthesisTest, SaysWhyThereIsNothing) {
  EXPECT_EQ(say("x", {{"broken", "1"}}).error().message,
            "LetterTTS: it is broken");
  EXPECT_THAT(say("refuse").error().message, HasSubstr("that is no word"));
  EXPECT_EQ(say("fail").error().message, "LetterTTS: the engine has died");
  EXPECT_EQ(say("hang").error().message,
            "LetterTTS: it has said nothing for 1 s");
  EXPECT_EQ(say("x", {{"throws", "1"}}).error().message,
            "LetterTTS: it throws 'no voice'");
  EXPECT_EQ(say("throw").error().message, "LetterTTS: it throws 'no memory'");
  EXPECT_EQ(say("throw later").error().message, "LetterTTS: it throws 'late'");
  EXPECT_THAT(say("other rate").error().message, HasSubstr("16,000 samples"));
  EXPECT_THAT(say("").error().message, HasSubstr("nothing to be heard"));
}

} // namespace
} // namespace parlour::tools
