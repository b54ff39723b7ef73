#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/nlg/phrase_nlg.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using test::message;
using testing::ElementsAre;

// Knows one phrase and shows what it was handed.
class OnePhrase : public PhraseEvaluator {
public:
  Rendering render(const Value& say) const override {
    if (say["act"] == Value("fail"))
      return {std::nullopt,
              {{ErrorKind::arithmetic, "no number", {"a.xml", 7}}}};
    if (say["act"] != Value("ask"))
      return {};
    return {"What is the " + say["slot"].text() + "? " + say["data"].text()};
  }
};

class PhraseNLGTest : public testing::Test {
protected:
  void SetUp() override {
    host.evaluator = std::make_shared<OnePhrase>();
    plugin = phrase_nlg_factory().create();
    ASSERT_TRUE(plugin->start(host, {}));
  }

  std::vector<std::string> generate(std::vector<Value> params) {
    plugin->receive(message("Generate", std::move(params)));
    return host.take_events();
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(PhraseNLGTest, ReturnsATextAsItIs) {
  EXPECT_THAT(generate({"Good morning."}), ElementsAre("Speak(Good morning.)"));
  EXPECT_THAT(generate({12}), ElementsAre("Speak(12)"));
}

TEST_F(PhraseNLGTest, RendersAnAct) {
  Map say{{"act", "ask"}, {"slot", "time"}, {"data", 1}};
  EXPECT_THAT(generate({say}), ElementsAre("Speak(What is the time? 1)"));
}

TEST_F(PhraseNLGTest, AddsDataWhereTheActHasNone) {
  Map say{{"act", "ask"}, {"slot", "time"}};
  EXPECT_THAT(generate({say, 2}), ElementsAre("Speak(What is the time? 2)"));
  say.set("data", 1);
  EXPECT_THAT(generate({say, 2}), ElementsAre("Speak(What is the time? 1)"));
}

TEST_F(PhraseNLGTest, IsNotSilentWhereNoPhraseApplies) {
  Map say{{"act", "greet"}, {"topic", "Facility"}};
  EXPECT_THAT(generate({say}),
              ElementsAre("Speak()", "NoPhrase(greet, Facility)"));
  EXPECT_THAT(generate({}),
              ElementsAre("Speak()", "NoPhrase(unknown, unknown)"));
}

TEST_F(PhraseNLGTest, TellsOfAPhraseThatCannotBeComputed) {
  EXPECT_THAT(generate({Map{{"act", "fail"}}}),
              ElementsAre("Speak()", "NoPhrase(fail, unknown)",
                          "PhraseFailed(no number, a.xml, 7)"));
}

TEST_F(PhraseNLGTest, HasNoPhraseWithoutAnEvaluator) {
  host.evaluator = nullptr;
  EXPECT_THAT(generate({Map{{"act", "ask"}}}),
              ElementsAre("Speak()", "NoPhrase(ask, unknown)"));
}

TEST_F(PhraseNLGTest, RefusesOtherCommands) {
  plugin->receive(message("Sing"));
  EXPECT_THAT(
      host.take_events(),
      ElementsAre("Failed(PhraseNLG does not know the command 'Sing'.)"));
}

TEST_F(PhraseNLGTest, AnswersWithSessionAndCorrelation) {
  plugin->receive(message("Generate", {"Hello."}, "s4", 11));
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "s4");
  EXPECT_EQ(host.events[0].correlation, 11u);
}

TEST(PhraseNLG, DescribesItselfAsInline) {
  const auto factory = phrase_nlg_factory();
  EXPECT_TRUE(factory.description.is_inline);
  EXPECT_THAT(factory.description.roles, ElementsAre("NLG"));
  EXPECT_TRUE(dynamic_cast<InlinePlugin*>(factory.create().get()));
}

} // namespace
} // namespace parlour::adapters
