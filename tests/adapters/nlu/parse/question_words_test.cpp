#include <gtest/gtest.h>

#include "adapters/nlu/parse/question_words.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// Whether the act, of these words, says the same as the question.
bool repeats(const std::string& text, const std::string& question,
             const std::string& name = "cancel") {
  const Stages stages("public <x> = hello;", text,
                      Value(Map{{"confirms", question}}));
  BuiltAct act;
  act.act = name;
  act.end = static_cast<std::uint32_t>(stages.utterance.size());
  return QuestionWords(stages.utterance, stages.context).has_all_of(act);
}

TEST(QuestionWords, AreThoseOfTheQuestionAndItsNumbers) {
  const Stages stages(
      "public <x> = hello;", "set eight nine",
      Value(Map{{"confirms", "A call at 8am: shall I set it?"}}));
  const QuestionWords words(stages.utterance, stages.context);
  EXPECT_TRUE(words.has(0));
  EXPECT_TRUE(words.has(1));
  EXPECT_FALSE(words.has(2));
}

TEST(QuestionWords, AreAllOfAnActThatNamesNothingElse) {
  EXPECT_TRUE(repeats("cancel it", "Shall I cancel the call?"));
  EXPECT_FALSE(repeats("cancel it", "Shall I set the call?"));
  // The act's name, in other words; but not what may mean the contrary.
  EXPECT_TRUE(repeats("get rid of it", "Shall I cancel the call?"));
  EXPECT_FALSE(repeats("leave it", "Shall I cancel the call?"));
  // One of two things.
  EXPECT_FALSE(repeats("lock the door", "I lock the door. Shall I?", "inform"));
}

} // namespace
} // namespace parlour::adapters::nlu::test
