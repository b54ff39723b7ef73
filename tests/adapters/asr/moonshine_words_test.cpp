#include <gmock/gmock.h>

#include "adapters/asr/moonshine_words.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters::moonshine {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(MoonshineWords, OfAGrammarAreWhatIsSpokenAsItStands) {
  EXPECT_THAT(
      grammar_words("#JSGF V1.0 UTF-8 en;\ngrammar desk;\n"
                    "// a comment (not spoken)\n"
                    "public <meet> = [<want>] (to meet | and see) /0.5/ the "
                    "boss @db:staff.name {Host} {topic=Visit}\n"
                    "  | i'm here; /* not | this */ <of> = s/o;\n"),
      ElementsAre("to meet", "and see", "the boss", "i'm here", "s", "o"));
}

TEST(MoonshineWords, AnUnfinishedGrammarHasWordsToo) {
  EXPECT_THAT(grammar_words("hello {tag"), ElementsAre("hello"));
  EXPECT_THAT(grammar_words("hello <rule"), ElementsAre("hello"));
  EXPECT_THAT(grammar_words("hello @db:a"), ElementsAre("hello"));
  EXPECT_THAT(grammar_words("hello // comment"), ElementsAre("hello"));
  EXPECT_THAT(grammar_words(""), IsEmpty());
}

TEST(MoonshineWords, OfAnExampleAreItsParts) {
  EXPECT_THAT(
      example_words("I am [David](Visitor), [here] from [Comptec](Firm)?"),
      ElementsAre("I am", "David", "here", "from", "Comptec"));
  EXPECT_THAT(example_words("I am [David](Visitor"),
              ElementsAre("I am", "David"));
  EXPECT_THAT(example_words("[](Visitor)"), IsEmpty());
  EXPECT_THAT(example_words(""), IsEmpty());
}

SlotModel slot(std::vector<std::string> values, std::string source = {}) {
  SlotModel made;
  made.values = std::move(values);
  made.source = std::move(source);
  return made;
}

TEST(MoonshineWords, OfAnApplicationComeOnceAndValuesFirst) {
  auto model = std::make_shared<UnderstandingModel>();
  model->grammars.push_back(
      {"desk", "public <a> = coffee shop | gym | toilet | to;", {}});
  TopicModel topic;
  topic.examples = {"is there a [gym](Place)"};
  topic.slots.push_back(slot({"gym", "bank"}));
  topic.slots.push_back(slot({}, "db:staff.name"));
  topic.slots.push_back(slot({}, "db:no.column"));
  topic.slots.push_back(slot({std::string(10'000, 'x'), ""}));
  model->topics.push_back(topic);
  test::FakePluginHost host;
  host.model = model;
  host.columns =
      [](const std::string& name) -> Expected<std::vector<std::string>> {
    if (name == "db:staff.name")
      return std::vector<std::string>{"Jeffery Ho", "gym"};
    return fail(ErrorKind::database, "there is no " + name);
  };
  const auto words = application_words(host, host.columns);
  EXPECT_EQ(words.names, 4U);
  EXPECT_THAT(words.phrases,
              ElementsAre("gym", "bank", "Jeffery Ho", "Jeffery", "coffee shop",
                          "toilet", "is there a"));
}

TEST(MoonshineWords, WithoutAnApplicationThereAreNone) {
  EXPECT_THAT(application_words(test::FakePluginHost(), {}).phrases, IsEmpty());
}

} // namespace
} // namespace parlour::adapters::moonshine
