#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/sphinx/sphinx_decoder.hpp"
#include "adapters/asr/sphinx/sphinx_keywords.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class SphinxKeywordsTest : public testing::Test {
protected:
  void SetUp() override {
    if (!asr::SphinxDecoder::is_built_in() || !test::can_speak())
      GTEST_SKIP() << "built without PocketSphinx or flite";
  }
  Expected<void> start(const Options& options) {
    plugin = sphinx_keywords_factory().create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params,
            const SessionId& session = "s1") {
    plugin->receive(
        test::message(std::move(command), std::move(params), session));
  }
  void say(const std::string& text, const SessionId& session = "s1") {
    send("Process", {pcm_value(asr::said(text))}, session);
  }
  // The phrases of the events.
  std::vector<std::string> found() {
    std::vector<std::string> texts;
    for (const auto& event : std::exchange(host.events, {})) {
      EXPECT_EQ(event.command, "Keyword");
      texts.push_back(event.session + ": " + event.params[0].text());
    }
    return texts;
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(SphinxKeywordsTest, Conforms) {
  EXPECT_THAT(conformance_errors(sphinx_keywords_factory(), {}), IsEmpty());
}

TEST_F(SphinxKeywordsTest, TellsWhereAPhraseWasSaid) {
  ASSERT_TRUE(start({{"keywords", "hello robot, computer"}}));
  send("Process", {pcm_value(test::silence(1'000)), 60'000});
  const auto sound = asr::said("Computer!");
  std::int64_t position = 61'000;
  for (std::size_t at = 0; at < sound.size(); at += frame_samples) {
    send("Process", {pcm_value(std::span(sound).subspan(
                         at, std::min(frame_samples, sound.size() - at))),
                     position});
    position += frame_time;
  }
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].params[0].text(), "computer");
  EXPECT_GE(host.events[0].params[1].number_or(0), 0.5);
  EXPECT_GT(host.events[0].params[2].integer_or(0), 61'500);
  EXPECT_LE(host.events[0].params[2].integer_or(0), position);
}

TEST_F(SphinxKeywordsTest, EachSessionHasAStreamOfItsOwn) {
  ASSERT_TRUE(start({{"keywords", "computer"}, {"streams", "2"}}));
  for (const auto* const session : {"a", "b", "c", "a"}) {
    say("computer", session);
    EXPECT_THAT(found(), ElementsAre(std::string(session) + ": computer"));
    host.advance(Milliseconds(3'000));
  }
}

// Frame by frame, in turn.
TEST_F(SphinxKeywordsTest, TooManySessionsDoNotDeafenTheOthers) {
  ASSERT_TRUE(start({{"keywords", "computer"}, {"streams", "2"}}));
  const auto sound = asr::said("computer");
  for (std::size_t at = 0; at < sound.size(); at += frame_samples) {
    const auto frame = pcm_value(std::span(sound).subspan(
        at, std::min(frame_samples, sound.size() - at)));
    for (const auto* const session : {"a", "b", "c"})
      send("Process", {frame}, session);
    host.advance(Milliseconds(frame_time));
  }
  std::vector<std::string> told;
  for (const auto& event : std::exchange(host.events, {}))
    told.push_back(event.session + ": " + event.command);
  EXPECT_THAT(told,
              UnorderedElementsAre("a: Keyword", "b: Keyword", "c: Failed"));
  host.advance(Milliseconds(5'000));
  say("computer", "c");
  EXPECT_THAT(found(), ElementsAre("c: computer"));
}

TEST_F(SphinxKeywordsTest, TakesOtherPhrases) {
  ASSERT_TRUE(start({}));
  say("computer");
  EXPECT_THAT(found(), IsEmpty());
  send("SetKeywords", {Value(List{"computer"})});
  say("computer");
  EXPECT_THAT(found(), ElementsAre("s1: computer"));
  send("SetKeywords", {Value(List{"?"})});
  EXPECT_THAT(host.take_events(),
              ElementsAre("Failed(a keyword has no words)"));
  say("computer");
  EXPECT_THAT(found(), ElementsAre("s1: computer"));
  send("SetKeywords", {Value(List{})});
  say("computer");
  EXPECT_THAT(found(), IsEmpty());
}

TEST_F(SphinxKeywordsTest, RefusesWrongOptionsAndOtherAudio) {
  EXPECT_FALSE(start({{"sensitivity", "2"}}));
  EXPECT_FALSE(start({{"streams", "0"}}));
  EXPECT_THAT(start({{"keywords", "a"}, {"model", "/no/such"}}).error().message,
              HasSubstr("pocketsphinx-en-us"));
  ASSERT_TRUE(start({{"keywords", "computer"}}));
  send("Process", {Binary{"pcm_s16le;rate=8000;channels=1", {}}});
  EXPECT_THAT(host.take_events(), ElementsAre(HasSubstr("16,000 samples")));
}

} // namespace
} // namespace parlour::adapters
