#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/sphinx/sphinx_asr.hpp"
#include "adapters/asr/sphinx/sphinx_decoder.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"

namespace parlour::adapters {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SphinxAsrTest : public testing::Test {
protected:
  void SetUp() override {
    if (!asr::SphinxDecoder::is_built_in() || !test::can_speak())
      GTEST_SKIP() << "built without PocketSphinx or flite";
    host.model = std::make_shared<UnderstandingModel>(asr::small_application());
    host.columns = asr::small_columns;
  }
  Expected<void> start(Options options = {}) {
    options.emplace("platform", test::source_path("config/platform"));
    plugin = sphinx_asr_factory().create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {},
            const SessionId& session = "s1") {
    plugin->receive(
        test::message(std::move(command), std::move(params), session));
  }
  void say(const std::string& text, const SessionId& session = "s1") {
    const auto sound = asr::said(text);
    for (std::size_t at = 0; at < sound.size(); at += frame_samples)
      send("DoRecognition",
           {pcm_value(std::span(sound).subspan(
               at, std::min(frame_samples, sound.size() - at)))},
           session);
  }
  // The last event.
  const Message& last() const {
    return host.events.back();
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(SphinxAsrTest, Conforms) {
  EXPECT_THAT(conformance_errors(sphinx_asr_factory(), {}), IsEmpty());
}

TEST_F(SphinxAsrTest, HearsASentence) {
  ASSERT_TRUE(start());
  say("Call Jeffery Ho.");
  send("Finish");
  ASSERT_EQ(last().command, "RecognitionResult");
  EXPECT_EQ(last().params[0].text(), "call Jeffery Ho");
  EXPECT_EQ(last().params[1].number_or(0), 1);
  EXPECT_THAT(*last().params[2].if_list(),
              ElementsAre(Value("call Jeffery Ho"), Value("call Jeffery Ho")));
  EXPECT_THAT(*last().params[3].if_list(), SizeIs(3));
  EXPECT_EQ(last().correlation, 7u);
}

TEST_F(SphinxAsrTest, TellsWhatItHearsMeanwhile) {
  ASSERT_TRUE(start());
  say("Bring me a hot chocolate please.");
  const auto partials = host.take_events();
  EXPECT_THAT(partials, Contains(HasSubstr("bring me")));
  EXPECT_THAT(partials.back(), HasSubstr("true)"));
  send("Cancel");
  send("Finish");
  EXPECT_THAT(host.take_events(),
              ElementsAre("Rejected(nothing was said that can be heard)"));
}

TEST_F(SphinxAsrTest, RejectsWhatDoesNotBelong) {
  ASSERT_TRUE(start());
  say("Two foxes live under the shed and come out when it gets dark.");
  send("Finish");
  EXPECT_EQ(last().command, "Rejected");
  send("DoRecognition", {pcm_value(test::silence(500))});
  send("Finish");
  EXPECT_EQ(last().command, "Rejected");
}

TEST_F(SphinxAsrTest, SessionsShareRecognisers) {
  ASSERT_TRUE(start({{"recognisers", "1"}}));
  say("Call Siti Aminah.", "one");
  say("I want coffee.", "two");
  send("Finish", {}, "two");
  host.take_events();
  send("Finish", {}, "one");
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(host.events[0].session, "one");
  EXPECT_EQ(host.events[0].params[0].text(), "call Siti Aminah");
  EXPECT_EQ(host.events[1].session, "two");
  EXPECT_EQ(host.events[1].params[0].text(), "I want coffee");
}

TEST_F(SphinxAsrTest, TakesRecognisersBackFromSessionsThatAreGone) {
  ASSERT_TRUE(start({{"recognisers", "1"}}));
  say("Call Siti", "gone");
  say("I want coffee.", "two");
  send("Finish", {}, "two");
  host.take_events();
  host.advance(Milliseconds(9'000));
  EXPECT_THAT(host.events, IsEmpty());
  host.advance(Milliseconds(2'000));
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "two");
  EXPECT_EQ(host.events[0].params[0].text(), "I want coffee");
}

TEST_F(SphinxAsrTest, NarrowsForOneSession) {
  ASSERT_TRUE(start());
  send("SetGrammar", {List{"Order.Drink"}});
  say("Lemon tea.");
  send("Finish");
  EXPECT_EQ(last().params[0].text(), "lemon tea");
  send("SetGrammar", {List{}});
  say("Call Jeffery Ho.");
  send("Finish");
  EXPECT_EQ(last().params[0].text(), "call Jeffery Ho");
}

TEST_F(SphinxAsrTest, RefusesWrongOptionsAndOtherAudio) {
  EXPECT_FALSE(start({{"recognisers", "0"}}));
  EXPECT_FALSE(start({{"least-agreement", "2"}}));
  EXPECT_THAT(start({{"model", "/no/such"}}).error().message,
              HasSubstr("pocketsphinx-en-us"));
  ASSERT_TRUE(start());
  send("DoRecognition", {Binary{"pcm_s16le;rate=8000;channels=1", {}}});
  EXPECT_THAT(host.take_events(), ElementsAre(HasSubstr("16,000 samples")));
}

} // namespace
} // namespace parlour::adapters
