#include <gmock/gmock.h>

#include "script/compiler/phrase_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

TEST(PhraseCompiler, reads_wordings_and_conditions) {
  const auto outcome = test::compile_declarations(
      "<topic name='t'><slot name='s'/></topic><phrases>"
      "<phrase act='invalid' topic='t' slot='s' if='data.value'>No "
      "{data.value} in {topic}.</phrase><phrase act='greet'>Hi</phrase>"
      "</phrases>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& phrases = outcome.program->phrases;
  ASSERT_GE(phrases.size(), 2u);
  EXPECT_EQ(phrases[0].act, "invalid");
  EXPECT_EQ(phrases[0].topic, "t");
  EXPECT_EQ(phrases[0].slot, "s");
  EXPECT_NE(phrases[0].condition, no_code);
  EXPECT_NE(phrases[0].text, no_code);
  EXPECT_EQ(phrases[1].condition, no_code);
}

TEST(PhraseCompiler, refuses_braces_that_would_be_said) {
  const auto lines_of = [](const std::string& words) {
    return test::compile_declarations("<phrases>\n<phrase act='greet'>" +
                                      words + "</phrase></phrases>")
        .lines;
  };
  for (const auto* words :
       {"Hi {count(2 'dogs')}", "Hi {data.name", "Hi data.name}", "{}"})
    EXPECT_THAT(lines_of(words), testing::ElementsAre(testing::HasSubstr(
                                     "error: this brace would be said")))
        << words;
  EXPECT_THAT(lines_of("Hi {typeof data}"),
              testing::ElementsAre(testing::HasSubstr("write type(x)")));
  EXPECT_THAT(lines_of("Hi {{data.name}} {data.name}"), testing::IsEmpty());
}

TEST(PhraseCompiler, the_platform_has_words_for_every_act_and_no_other) {
  const auto outcome = test::compile_declarations("");
  ASSERT_TRUE(outcome.program);
  std::vector<std::string> worded;
  for (const auto& phrase : outcome.program->phrases)
    worded.push_back(phrase.act);
  for (const auto& act : say_acts())
    EXPECT_THAT(worded, testing::Contains(act));
  for (const auto& act : worded)
    EXPECT_THAT(say_acts(), testing::Contains(act));
}

} // namespace parlour::script
