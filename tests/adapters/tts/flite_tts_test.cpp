#include <algorithm>

#include "adapters/tts/flite_synthesizer.hpp"
#include "adapters/tts/flite_tts.hpp"
#include "adapters/tts/spoken_text.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/tts/tts_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class FliteTtsTest : public test::TtsTest {
protected:
  void SetUp() override {
    if (const auto made = tts::make_flite_synthesizer(); !made)
      GTEST_SKIP() << made.error().message;
  }
  Expected<void> start(const Options& options = {}) {
    return TtsTest::start(flite_tts_factory(), options);
  }
  std::vector<Sample> said(const std::string& text) {
    send("Speak", {text, 1});
    return sound(events_until("Finished"));
  }
};

TEST_F(FliteTtsTest, conforms) {
  EXPECT_THAT(conformance_errors(flite_tts_factory(), {}), IsEmpty());
}

TEST_F(FliteTtsTest, speaks_with_each_voice) {
  for (const auto* voice : {"slt", "rms", "awb", "kal16"}) {
    ASSERT_TRUE(start({{"voice", voice}}));
    const auto samples = said("Good morning, how can I help you?");
    EXPECT_NEAR(static_cast<double>(duration(samples.size())), 2'400, 500)
        << voice;
    EXPECT_GT(std::ranges::max(samples), 3'000) << voice;
    plugin->stop();
  }
}

TEST_F(FliteTtsTest, marks_every_word_of_the_text_once) {
  ASSERT_TRUE(start({{"voice", "kal16"}}));
  const std::string text =
      "The café — “Zoë’s” — opens at 10:30am, on 23 May: call 87654321 (or 6). "
      "a<b & [[x]] ... \"Dr. Ho\" (the second), <break/> end.";
  send("Speak", {text, 1});
  const auto events = events_until("Finished");
  EXPECT_EQ(tts::joined(marked_words(events)), text);
  std::int64_t before = 0;
  std::int64_t beginnings = 0; // that differ
  for (const auto& mark : only(events, "Mark")) {
    const auto position = *mark.params[2].if_integer();
    EXPECT_GE(position, before);
    beginnings += position > before;
    before = position;
  }
  EXPECT_LE(before, duration(sound(events).size()));
  EXPECT_GT(beginnings, 18);
}

TEST_F(FliteTtsTest, speaks_as_its_options_say) {
  ASSERT_TRUE(start({{"voice", "kal16"}, {"rate", "350"}}));
  const auto fast = said("Good morning everybody").size();
  ASSERT_TRUE(start({{"voice", "kal16"}, {"rate", "90"}}));
  EXPECT_GT(said("Good morning everybody").size(), fast * 2);
  ASSERT_TRUE(start({{"volume", "20"}}));
  const auto quiet = std::ranges::max(said("Good morning"));
  ASSERT_TRUE(start());
  EXPECT_GT(std::ranges::max(said("Good morning")), quiet * 3);
}

TEST_F(FliteTtsTest, says_which_voices_there_are) {
  EXPECT_THAT(start({{"voice", "anna"}}).error().message,
              HasSubstr("no voice 'anna'; there are slt, rms"));
}

} // namespace
} // namespace parlour::adapters
