#include "adapters/nlu/acts/choice.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// The choice, "deny", or "" if nothing is chosen.
std::string chosen(const std::string& said, List choices) {
  const Value where = Map{
      {"asked", Map{{"topic", "Appointment"}, {"slot", "Host"}}},
      {"choices", std::move(choices)},
  };
  const Stages stages("#JSGF V1.0; grammar g; public <r> = hello;", said,
                      where);
  const auto act = choice_of(stages.utterance, stages.context);
  if (!act)
    return {};
  return act->fills.empty() ? act->act : act->fills[0].literal->text();
}

const List people{"Jeffery Ho", "Ho Hui Min", "Karen Ho"};

TEST(Choice, IsMadeByPlace) {
  EXPECT_EQ(chosen("the second one", people), "Ho Hui Min");
  EXPECT_EQ(chosen("The first, please.", people), "Jeffery Ho");
  EXPECT_EQ(chosen("I mean the last one", people), "Karen Ho");
  EXPECT_EQ(chosen("the latter", {"red cup", "blue cup"}), "blue cup");
  EXPECT_EQ(chosen("the fourth one", people), "");
  EXPECT_EQ(chosen("the seventh", {"a1", "b2", "c3", "d4", "e5", "f6", "g7"}),
            "g7");
}

TEST(Choice, IsMadeByAPartOfTheName) {
  EXPECT_EQ(chosen("the red one", {"red cup", "blue cup"}), "red cup");
  EXPECT_EQ(chosen("the cup", {"red cup", "blue cup"}), "");
}

TEST(Choice, IsMadeByALetter) {
  EXPECT_EQ(chosen("with a K", people), "Karen Ho");
  EXPECT_EQ(chosen("the one with a K", people), "Karen Ho");
  EXPECT_EQ(chosen("with an H", people), "");
}

TEST(Choice, MayBeLeftToTheRobot) {
  EXPECT_EQ(chosen("either", people), "Jeffery Ho");
  EXPECT_EQ(chosen("any of them", people), "Jeffery Ho");
  EXPECT_EQ(chosen("whichever is free", people), "Jeffery Ho");
  EXPECT_EQ(chosen("neither", people), "deny");
  EXPECT_EQ(chosen("none of them", people), "deny");
}

TEST(Choice, IsNoneIfSomethingElseIsSaid) {
  EXPECT_EQ(chosen("is there a bank on the second floor", people), "");
  EXPECT_EQ(chosen("not the second one", people), "");
  EXPECT_EQ(chosen("yes", people), "");
  EXPECT_EQ(chosen("the second one", {}), "");
}

} // namespace
} // namespace parlour::adapters::nlu::test
