#include <gtest/gtest.h>

#include "adapters/nlu/acts/other_terms.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// The words that make a yes, the first token, one to something else.
std::string terms(const std::string& said, const std::string& question,
                  const std::vector<BuiltAct>& more = {},
                  const std::string& current = "") {
  const Stages stages(
      "#JSGF V1.0; grammar g; public <r> = hello;", said,
      Map{{"now", sample_now()}, {"confirms", question}, {"current", current}});
  BuiltAct yes;
  yes.act = "confirm";
  yes.end = 1;
  auto acts = more;
  acts.push_back(yes);
  const auto found =
      other_terms(stages.utterance, acts, acts.back(), stages.context);
  return found ? stages.words(found->begin, found->end) : "";
}

const char* const question = "A table at six: shall I book it?";

TEST(OtherTerms, AreTimesThatTheQuestionDoesNotName) {
  EXPECT_EQ(terms("yes in an hour", question), "in an hour");
  EXPECT_EQ(terms("okay, tomorrow", question), "tomorrow");
  EXPECT_EQ(terms("yes, later", question), "later");
  for (const auto* text :
       {"yes", "yes please", "yes now", "yes today", "yes, at six",
        "yes, it's half past nine already", "yes please. We came yesterday.",
        "yes, see you tomorrow"})
    EXPECT_EQ(terms(text, question), "") << text;
}

TEST(OtherTerms, AreConditionsInTheSentenceOfTheYes) {
  EXPECT_EQ(terms("yes if it is free", question), "if it is free");
  EXPECT_EQ(terms("yes, after lunch", question), "after lunch");
  EXPECT_EQ(terms("yes for the other room", question), "other room");
  EXPECT_EQ(terms("yes. The other room is cold", question), "");
}

TEST(OtherTerms, AreNotWhatIsSaidOfSomething) {
  BuiltAct act;
  act.topic = 2; // Taxi
  act.begin = 1;
  act.end = 4;
  act.elliptical = true;
  EXPECT_EQ(terms("yes in an hour", question, {act}), "in an hour");
  EXPECT_EQ(terms("yes in an hour", question, {act}, "Taxi"), "");
  // A sentence about something else.
  act.elliptical = false;
  act.end = 6;
  EXPECT_EQ(terms("yes is it open after six", question, {act}), "");
}

TEST(OtherTerms, NeedAQuestion) {
  EXPECT_EQ(terms("yes in an hour", ""), "");
}

} // namespace
} // namespace parlour::adapters::nlu::test
