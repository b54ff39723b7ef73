#include <algorithm>

#include "adapters/tts/espeak_tts.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/tts/tts_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class EspeakTtsTest : public test::TtsTest {
protected:
  void SetUp() override {
    if (!tts::espeak_engine().use())
      GTEST_SKIP() << "libespeak-ng is missing";
  }
  Expected<void> start(const Options& options = {}) {
    return TtsTest::start(espeak_tts_factory(), options);
  }
  std::vector<Sample> said(const std::string& text) {
    send("Speak", {text, 1});
    return sound(events_until("Finished"));
  }
  static int loudness(const std::vector<Sample>& sound) {
    return std::ranges::max(sound);
  }
};

TEST_F(EspeakTtsTest, conforms) {
  EXPECT_THAT(conformance_errors(espeak_tts_factory(), {}), IsEmpty());
}

TEST_F(EspeakTtsTest, speaks) {
  ASSERT_TRUE(start());
  send("Speak", {"Good morning, how can I help you?", 1});
  const auto events = events_until("Finished");
  EXPECT_THAT(marked_words(events), ElementsAre("Good", "morning,", "how",
                                                "can", "I", "help", "you?"));
  const auto samples = sound(events);
  EXPECT_NEAR(static_cast<double>(duration(samples.size())), 1'850, 300);
  EXPECT_GT(loudness(samples), 5'000);
}

// Words that become several, others that are silent.
TEST_F(EspeakTtsTest, marks_every_word_of_the_text_once) {
  ASSERT_TRUE(start());
  const std::string text = "The café — “Zoë’s” — opens at 10:30am, on 23 May: "
                           "call 87654321 (or 6).";
  send("Speak", {text, 1});
  const auto events = events_until("Finished");
  EXPECT_EQ(tts::joined(marked_words(events)), text);
  std::int64_t before = 0;
  for (const auto& mark : only(events, "Mark")) {
    EXPECT_GE(*mark.params[2].if_integer(), before);
    before = *mark.params[2].if_integer();
  }
  EXPECT_LE(before, duration(sound(events).size()));
}

TEST_F(EspeakTtsTest, takes_no_orders_from_the_text) {
  ASSERT_TRUE(start());
  const auto plain = said("before after").size();
  // Where it is interpreted, a break is silence and an order is not heard.
  EXPECT_GT(said("before <break time=\"3s\"/> after").size(), plain * 2);
  EXPECT_GT(said("before &lt; after").size(), plain);
  EXPECT_GT(said("before [[h@'loU]] after").size(), plain);
  EXPECT_GT(said("before \x01\x35\x30\x30S after").size(), plain);
}

TEST_F(EspeakTtsTest, speaks_as_its_options_say) {
  ASSERT_TRUE(start({{"rate", "350"}}));
  const auto fast = said("Good morning everybody").size();
  ASSERT_TRUE(start({{"rate", "90"}}));
  EXPECT_GT(said("Good morning everybody").size(), fast * 2);
  ASSERT_TRUE(start({{"volume", "20"}}));
  const auto quiet = loudness(said("Good morning everybody"));
  ASSERT_TRUE(start({{"volume", "100"}}));
  EXPECT_GT(loudness(said("Good morning everybody")), quiet * 2);
}

TEST_F(EspeakTtsTest, says_which_voices_there_are) {
  for (const auto* name : {"nobody", "../voices/!v/f1", "a b", "xx-yy+f1"}) {
    const auto started = start({{"voice", name}});
    ASSERT_FALSE(started) << name;
    EXPECT_THAT(started.error().message, HasSubstr("en-us, en-gb"));
  }
  for (const auto* name : {"en-gb", "en-gb+f3", "en-us+m1", "fr-fr", "de"})
    EXPECT_TRUE(start({{"voice", name}})) << name;
}

TEST_F(EspeakTtsTest, speaks_a_long_text_to_its_end) {
  ASSERT_TRUE(start({{"one-by-one", "true"}}));
  std::string text;
  while (text.size() < 2'900)
    text += "The lift to the second floor is behind the café on your left. ";
  send("Speak", {text, 1});
  EXPECT_LT(host.take_events().size(), 120u);
  host.advance(Milliseconds(1'000'000));
  const auto events = host.take_events();
  EXPECT_GT(duration(sound(events).size()), 100'000);
  EXPECT_EQ(only(events, "Finished").size(), 1u);
}

} // namespace
} // namespace parlour::adapters
