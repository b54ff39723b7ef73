#include "adapters/nlu/keywords/keyword_matcher.hpp"
#include "tests/adapters/nlu/keywords/keyword_fixture.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// "act topic slot=value …", "~" before what is elliptical.
std::string shown(const Value& act) {
  std::string text = act[act_key::elliptical] ? "~" : "";
  text += act[act_key::act].text();
  if (!act[act_key::topic].is_unknown())
    text += ' ' + act[act_key::topic].text();
  for (const auto& [name, fill] : act[act_key::slots].if_map()->entries()) {
    const auto& candidates = fill[act_key::candidates];
    const auto& value = fill.if_map() ? fill[act_key::value] : fill;
    text += ' ' + name + '=' +
            to_string(candidates.is_unknown() ? value : candidates);
  }
  return text;
}

class KeywordMatcherTest : public testing::Test {
protected:
  std::vector<std::string> of(const std::string& text, Map context = {}) {
    context.set("now", *parse_timestamp("2026-11-21 09:00"));
    std::vector<std::string> acts;
    for (const auto& act : matcher.understand(text, context))
      acts.push_back(shown(act));
    return acts;
  }
  static Map asked(const char* topic, const char* slot) {
    return {{"asked", Map{{"topic", topic}, {"slot", slot}}}};
  }

  KeywordMatcher matcher{desk_rules()};
};

TEST_F(KeywordMatcherTest, FillsSlotsOfTheTopicThatAKeywordTells) {
  EXPECT_THAT(of("can I borrow Rover tomorrow, for my thesis on cups, please"),
              ElementsAre("inform Borrow Robot=Rover Day=2026-11-22 "
                          "Purpose=my thesis on cups"));
  EXPECT_THAT(of("BOOK A ROBOT!"), ElementsAre("inform Borrow"));
  EXPECT_THAT(of("book two robots"), IsEmpty());
}

TEST_F(KeywordMatcherTest, FindsAValueBehindAWordOnlyNearIt) {
  EXPECT_THAT(of("where is the Spot"), ElementsAre("request Where Robot=Spot"));
  EXPECT_THAT(of("where Spot"), ElementsAre("request Where"));
}

TEST_F(KeywordMatcherTest, GivesAnActForEachTopicInTheOrderOfTheText) {
  EXPECT_THAT(
      of("where is Rover, and can I borrow Spot"),
      ElementsAre("request Where Robot=Rover", "inform Borrow Robot=Rover"));
  EXPECT_THAT(of("borrow anything at all"),
              ElementsAre("inform Borrow", "request Where Skill=any"));
}

TEST_F(KeywordMatcherTest, TellsWhatIsAmbiguous) {
  EXPECT_THAT(of("borrow the Fox"),
              ElementsAre("inform Borrow Robot=[Red Fox, Grey Fox]"));
}

TEST_F(KeywordMatcherTest, TakesGenericActsWhereThereIsNoTopic) {
  EXPECT_THAT(of("Good morning."), ElementsAre("greet"));
  EXPECT_THAT(of("good morning, where is Rover"),
              ElementsAre("request Where Robot=Rover"));
  EXPECT_THAT(of("the weather"), IsEmpty());
  EXPECT_THAT(of(""), IsEmpty());
}

TEST_F(KeywordMatcherTest, GoesOnWithWhatWasAskedOrTheCurrentTopic) {
  EXPECT_THAT(of("Spot", asked("Borrow", "Robot")),
              ElementsAre("~inform Borrow Robot=Spot"));
  EXPECT_THAT(of("my thesis", asked("Borrow", "Purpose")),
              ElementsAre("~inform Borrow Purpose=my thesis"));
  EXPECT_THAT(of("good morning", asked("Borrow", "Purpose")),
              ElementsAre("greet"));
  EXPECT_THAT(of("how about talking?", {{"current", "Where"}}),
              ElementsAre("~request Where Skill=talking"));
  EXPECT_THAT(of("how about talking?", {{"resting", "Where"}}),
              ElementsAre("~request Where Skill=talking"));
  EXPECT_THAT(of("how about singing?", {{"current", "Where"}}), IsEmpty());
}

constexpr const char* yes_or_no_xml = R"(<keywords>
  <rule act="confirm"><keyword>yes</keyword><keyword>absolutely</keyword></rule>
  <rule act="deny"><keyword>no</keyword><keyword>not</keyword></rule>
  <rule act="help"><keyword>help</keyword></rule>
  <rule act="thank"><keyword>thanks</keyword></rule>
</keywords>)";

std::string answer(const std::string& text, const Value& context = Map()) {
  auto model = desk_model();
  model.topics.push_back(
      {"Fee", false, {{"Pays", "set", {"yes", "no"}, "", false, false}}, {}});
  auto rules =
      read_keyword_rules(yes_or_no_xml, "keywords.xml", model, desk_columns());
  const KeywordMatcher matcher(std::move(*rules));
  const auto acts = matcher.understand(text, context);
  return acts.empty() ? "" : shown(acts.front());
}

TEST(KeywordAnswers, AYesIsOneWhereNothingElseIsSaid) {
  EXPECT_EQ(answer("yes please"), "confirm");
  EXPECT_EQ(answer("thanks, yes"), "confirm");
  EXPECT_EQ(answer("no"), "deny");
  EXPECT_EQ(answer("absolutely not"), "");
  EXPECT_EQ(answer("yes and no"), "");
  EXPECT_EQ(answer("yes if it is cheap"), "");
  EXPECT_EQ(answer("yes help"), "help");
}

TEST(KeywordAnswers, AYesIsForTheQuestionThatWantsIt) {
  const auto context = [](const char* question) {
    return Value(Map{{"current", "Fee"}, {"confirms", question}});
  };
  EXPECT_EQ(answer("yes", Map{{"current", "Fee"}}), "confirm");
  EXPECT_EQ(
      answer("yes", Map{{"asked", Map{{"topic", "Fee"}, {"slot", "Pays"}}}}),
      "~inform Fee Pays=yes");
  EXPECT_EQ(answer("yes", context("Shall I book it?")), "confirm");
  EXPECT_EQ(answer("yes book it", context("Shall I book it?")), "confirm");
}

} // namespace
} // namespace parlour::adapters::nlu
