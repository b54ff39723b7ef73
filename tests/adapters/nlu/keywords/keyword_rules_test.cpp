#include "tests/adapters/nlu/keywords/keyword_fixture.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> errors_of(const std::string& rules) {
  const auto read =
      read_keyword_rules(rules, "keywords.xml", desk_model(), desk_columns());
  std::vector<std::string> texts;
  if (!read)
    for (const auto& error : read.error())
      texts.push_back(to_string(error));
  return texts;
}

TEST(KeywordRules, AreReadInTheirOrder) {
  const auto read = desk_rules();
  ASSERT_EQ(read.rules.size(), 4u);
  const auto& borrow = read.rules[0];
  EXPECT_EQ(borrow.act, "inform");
  EXPECT_THAT(borrow.keywords, ElementsAre(ElementsAre("borrow"),
                                           ElementsAre("book", "a", "robot")));
  ASSERT_EQ(borrow.slots.size(), 3u);
  EXPECT_TRUE(is_set(borrow.slots[0].entity));
  EXPECT_THAT(borrow.slots[2].after, ElementsAre("for"));
  EXPECT_EQ(read.rules[1].act, "request"); // of an enquiry
  EXPECT_EQ(read.rules[3].topic, no_topic);
}

TEST(KeywordRules, SayAllThatIsWrongWithItsLine) {
  EXPECT_THAT(
      errors_of(
          "<keywords>\n"
          "<rule topic='Borow'><keyword>a</keyword><slot name='x'/></rule>\n"
          "<rule act='sing'/>\n"
          "<rule><keyword> , </keyword></rule>\n"
          "<rule topic='Borrow' when='now'><keyword>a</keyword>\n"
          "  <slot name='Size'/><slot name='Purpose'/>\n"
          "  <slot name='Robot' after='a' value='b'/><grammar/>\n"
          "</rule>\n"
          "<rule act='help'><keyword>h</keyword><slot name='Day'/></rule>\n"
          "<phrase/>\n"
          "</keywords>"),
      ElementsAre(
          "keywords.xml:2: there is no topic 'Borow'; there are Borrow, Where",
          HasSubstr("keywords.xml:3: there is no act 'sing'; there are inform"),
          "keywords.xml:3: a rule has at least one <keyword>",
          "keywords.xml:4: a rule has a topic, an act, or both",
          "keywords.xml:4: this keyword has no word",
          "keywords.xml:4: a rule has at least one <keyword>",
          "keywords.xml:5: <rule> has no attribute 'when'; there are topic, "
          "act",
          "keywords.xml:6: the topic Borrow has no slot 'Size'; there are "
          "Robot, Day, Purpose",
          "keywords.xml:6: any words can be the slot Purpose: say what they "
          "stand after, or its value",
          "keywords.xml:7: a slot has a value or stands after something, not "
          "both",
          "keywords.xml:7: <grammar> is not known here; a <keyword> or a "
          "<slot> "
          "is",
          "keywords.xml:9: a rule without a topic has no slots",
          "keywords.xml:10: <phrase> is not known here; a <rule> is"));
}

TEST(KeywordRules, AreXml) {
  EXPECT_THAT(errors_of("<keywords>\n<rule>\n"),
              ElementsAre(HasSubstr("keywords.xml:2: this is no XML: ")));
  EXPECT_THAT(errors_of(""), ElementsAre(HasSubstr("this is no XML")));
  EXPECT_THAT(errors_of("<rules/>"),
              ElementsAre(HasSubstr("<keywords>, not <rules>")));
}

TEST(KeywordRules, ReadTheColumnsOfSlots) {
  const auto read = read_keyword_rules(
      "<keywords/>", "keywords.xml", desk_model(), [](const std::string&) {
        return Expected<std::vector<std::string>>(
            fail(ErrorKind::database, "it is closed"));
      });
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().front().message, HasSubstr("it is closed"));
}

} // namespace
} // namespace parlour::adapters::nlu
