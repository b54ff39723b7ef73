#include <gmock/gmock.h>

#include "script/compiler/understanding_builder.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;

TEST(UnderstandingBuilder, tells_topics_slots_and_examples) {
  const auto outcome = test::compile_declarations(
      "<topic name='t' kind='enquiry'><slot name='C' type='Functional'>"
      "<cardinality type='set'><value> Sky  garden </value><value>Pool</value>"
      "<value expr='1'/></cardinality></slot><slot name='N'/>"
      "<query source='db' param='select 1'><by slot='C'/></query>"
      "<examples><value>where is the [pool](C)</value></examples></topic>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& model = *outcome.program->understanding;
  ASSERT_EQ(model.topics.size(), 1u);
  const auto& topic = model.topics[0];
  EXPECT_TRUE(topic.enquiry);
  EXPECT_THAT(topic.examples, ElementsAre("where is the [pool](C)"));
  ASSERT_EQ(topic.slots.size(), 2u);
  EXPECT_THAT(topic.slots[0].values, ElementsAre("Sky garden", "Pool"));
  EXPECT_TRUE(topic.slots[0].functional);
  EXPECT_TRUE(topic.slots[0].relevant_to_query);
  EXPECT_FALSE(topic.slots[1].relevant_to_query);
}

TEST(UnderstandingBuilder, takes_grammars_from_text_and_files) {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings><Scripts><Script>a.xml</Script>"
                               "</Scripts></settings>");
  folder.write("a.xml", "<dialogue>\n<grammar name='a'>\n  #JSGF V1.0;\n"
                        "</grammar>\n<grammar name='b' file='g/b.jsgf'/>"
                        "</dialogue>");
  folder.write("g/b.jsgf", "#JSGF V1.0; grammar b;");
  const auto compiled = compile_application(folder.path(), test::platform());
  ASSERT_TRUE(compiled.program);
  const auto& grammars = compiled.program->understanding->grammars;
  ASSERT_EQ(grammars.size(), 2u);
  EXPECT_EQ(grammars[0].text, "#JSGF V1.0;\n");
  EXPECT_EQ(grammars[0].place.line, 3u);
  EXPECT_EQ(grammars[1].name, "b");
  EXPECT_EQ(grammars[1].text, "#JSGF V1.0; grammar b;");
}

TEST(UnderstandingBuilder, takes_how_words_sound) {
  const auto outcome =
      test::compile_declarations("<pronounce word='Ho' as=' HH  OW '/>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& sounds = outcome.program->understanding->pronunciations;
  ASSERT_EQ(sounds.size(), 1u);
  EXPECT_EQ(sounds[0].word, "Ho");
  EXPECT_EQ(sounds[0].phones, "HH OW");
}

TEST(UnderstandingBuilder, names_the_phone_that_does_not_exist) {
  for (const auto& [wrong, text] :
       {std::pair("<pronounce word='Ho' as='HH OQ'/>", "no phone 'OQ'"),
        std::pair("<pronounce word='Ho' as=''/>", "no phones are given"),
        std::pair("<pronounce word='Jeffery Ho' as='HH OW'/>", "one word")}) {
    const auto outcome = test::compile_declarations(wrong);
    EXPECT_FALSE(outcome.program);
    ASSERT_FALSE(outcome.lines.empty());
    EXPECT_THAT(outcome.lines[0], testing::HasSubstr(text));
  }
}

TEST(UnderstandingBuilder, takes_the_bounds_that_are_written) {
  const auto outcome = test::compile_declarations(
      "<topic name='Loan'>"
      "<slot name='Card'><cardinality type='range' from='10000' to='99999'/>"
      "</slot>"
      "<slot name='Days'><cardinality type='range' from='1' to='3 + 4'/></slot>"
      "</topic>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& slots = outcome.program->understanding->topics[0].slots;
  EXPECT_EQ(slots[0].least, 10'000);
  EXPECT_EQ(slots[0].most, 99'999);
  EXPECT_EQ(slots[1].most, 0);
}

} // namespace parlour::script
