#include <gtest/gtest.h>

#include "adapters/nlu/parse/clause_filters.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

std::string understood(const char* text, const char* question = nullptr) {
  static const auto engine = sample();
  Map context{{"now", sample_now()}};
  if (question)
    context.set("confirms", question);
  return summary(engine.understand(text, Value(context)).acts);
}

TEST(ClauseFilters, LeaveOutTheStopOfAQuestion) {
  EXPECT_EQ(understood("Where do the taxis stop"), "");
  EXPECT_EQ(understood("and where do the taxis stop?"), "");
  EXPECT_EQ(understood("can I leave it with you"), "");
  EXPECT_EQ(understood("where can I drop it now"), "");
  EXPECT_EQ(understood("can we please leave it"), "cancel");
  EXPECT_EQ(understood("can we leave it for now please"), "cancel");
  EXPECT_EQ(understood("stop"), "cancel");
  EXPECT_EQ(understood("where are we, stop"), "cancel");
  EXPECT_EQ(understood("the taxis stop"), "cancel");
}

TEST(ClauseFilters, LeaveOutAYesThatIsHalfAClause) {
  EXPECT_EQ(understood("no, wait, it's the bank"),
            "~correct Facility Category=bank");
  EXPECT_EQ(understood("you can ring him"), "");
  EXPECT_EQ(understood("it is"), "confirm");
  EXPECT_EQ(understood("it is, thank you"), "confirm");
  EXPECT_EQ(understood("you can"), "confirm");
  EXPECT_EQ(understood("yes, do it"), "confirm");
  EXPECT_EQ(understood("it is the blue one", "The blue one: is that right?"),
            "confirm");
}

TEST(ClauseFilters, TakeThatsItForNoMoreWhereMoreIsAskedFor) {
  EXPECT_EQ(understood("that's it", "Anything else?"), "deny");
  EXPECT_EQ(understood("no thanks, that's it", "Anything else?"), "deny");
  EXPECT_EQ(understood("that's everything, thank you", "Anything else?"),
            "deny");
  EXPECT_EQ(understood("that's it", "Is it seven?"), "confirm");
  EXPECT_EQ(understood("that's it"), "confirm");
}

TEST(ClauseFilters, LeaveOutAYesWithinAQuestion) {
  EXPECT_EQ(understood("which floor is that correct office on"), "");
  EXPECT_EQ(understood("that is correct"), "confirm");
}

TEST(ClauseFilters, LeaveOutANoThatBelongsToANoun) {
  EXPECT_EQ(understood("my phone has no zork"), "");
  EXPECT_EQ(understood("no"), "deny");
  EXPECT_EQ(understood("oh no"), "deny");
}

TEST(ClauseFilters, LeaveOutACorrectionThatIsTold) {
  EXPECT_EQ(understood("we will never make that. I need a taxi"),
            "inform Taxi");
  EXPECT_EQ(understood("make that the bank"),
            "~correct Facility Category=bank");
  EXPECT_EQ(understood("can you please make that the bank"),
            "~correct Facility Category=bank");
}

TEST(ClauseFilters, LeaveOutAByeThatGoesOn) {
  EXPECT_EQ(understood("I have to go"), "bye");
  EXPECT_EQ(understood("I have to go now, thank you"), "bye");
  EXPECT_EQ(understood("I have to go out"), "");
  EXPECT_EQ(understood("I have to go to the doctor"), "");
}

TEST(ClauseFilters, BeginAnewOnlyWhereNothingElseIsSaid) {
  for (const auto* text :
       {"start over", "let us start again please", "wait, can we start again?",
        "no, I would like to start over", "well then start again"})
    EXPECT_EQ(understood(text), "restart") << text;
  EXPECT_EQ(understood("start over, I need a taxi"), "restart + inform Taxi");
  EXPECT_EQ(understood("start over I need a taxi"), "restart + inform Taxi");
  for (const auto* text :
       {"when does the film start again", "they start again tonight",
        "can I start again tomorrow", "it will start over"})
    EXPECT_EQ(understood(text).find("restart"), std::string::npos) << text;
}

TEST(ClauseFilters, TakeAQuestionBehindAStatementForPartOfIt) {
  EXPECT_EQ(understood("is there a bank in here, isn't there?"),
            "request Facility Category=bank");
  EXPECT_EQ(understood("you need a taxi, don't you?"), "inform Taxi");
  // What goes on is a question of its own.
  EXPECT_EQ(understood("isn't there a bank?"), understood("is there a bank?"));
}

TEST(ClauseFilters, NeverMindWhatIsNamed) {
  EXPECT_EQ(understood("never mind the bank. is there a toilet"),
            "cancel + request Facility Category=toilet");
  EXPECT_EQ(understood("mind the bank"), understood("the bank"));
}

TEST(ClauseFilters, LeaveOutOrdersThatAreAskedAbout) {
  const auto orders = [](const char* text) {
    Stages stages(
        "public <a> = need a taxi {topic=Taxi} {act=inform};\n"
        "public <b> = is the bank open {topic=Facility} {act=request};",
        text);
    auto islands = stages.islands;
    leave_out_past_orders(islands, stages.utterance, stages.schema);
    return islands.size();
  };
  EXPECT_EQ(orders("need a taxi"), 1U);
  EXPECT_EQ(orders("did I need a taxi"), 0U);
  EXPECT_EQ(orders("why did he need a taxi"), 0U);
  EXPECT_EQ(orders("I did need a taxi"), 1U);
  EXPECT_EQ(orders("where did you say, need a taxi"), 1U);
  EXPECT_EQ(orders("did you say is the bank open"), 1U); // no order
  // Further orders, and what is only told.
  EXPECT_EQ(orders("where did you go I need a taxi"), 1U);
  EXPECT_EQ(orders("did you know need a taxi"), 1U);
  EXPECT_EQ(orders("did I need a taxi or need a taxi"), 1U);
}

} // namespace
} // namespace parlour::adapters::nlu::test
