#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/talk/thoughts.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Inspection message(std::string command, std::vector<Value> params) {
  auto made = std::make_shared<Message>();
  made->source = "GrammarNLU";
  made->command = std::move(command);
  made->params = std::move(params);
  return {InspectionKind::message, "s", "", "", made, "session"};
}

Value taxi() {
  return Map{{"act", "inform"},
             {"topic", "Taxi"},
             {"confidence", 0.95},
             {"slots", Map{{"Time", Map{{"value", "15:00"}}},
                           {"Place", Map{{"value", Value()},
                                         {"candidates", List{"A", "B"}}}}}}};
}

TEST(Thoughts, tell_what_was_understood) {
  Thoughts thoughts;
  thoughts.note(message("FrameInfo", {taxi(), Map{{"act", "thank"}}}));
  EXPECT_THAT(thoughts.lines(),
              ElementsAre("understood  inform Taxi (0.95): Time = 15:00, "
                          "Place = [A, B]",
                          "understood  thank"));
  thoughts.begin_turn();
  thoughts.note(message("NoResult", {"hm"}));
  EXPECT_THAT(thoughts.lines(), ElementsAre("understood  nothing"));
}

TEST(Thoughts, tell_where_the_dialogue_stands) {
  Thoughts thoughts;
  thoughts.note({InspectionKind::transition, "s", "Welcome", "from ''"});
  thoughts.note({InspectionKind::topic, "s", "Taxi", "active"});
  thoughts.note({InspectionKind::slot, "s", "Taxi.Time", "3pm (accepted)"});
  thoughts.begin_turn();
  thoughts.note({InspectionKind::slot, "s", "Taxi.Time", "4pm (accepted)"});
  EXPECT_THAT(thoughts.lines(),
              ElementsAre("state       Welcome",
                          "topic       Taxi active: Time = 4pm (accepted)",
                          "before      slot        Taxi.Time: 4pm (accepted)"));
}

TEST(Thoughts, are_about_the_recent_past) {
  Thoughts thoughts;
  for (int i = 0; i < 100; ++i)
    thoughts.note({InspectionKind::log, "s", "info", std::to_string(i)});
  EXPECT_EQ(thoughts.lines().size(), 12u);
  EXPECT_EQ(thoughts.lines().back(), "before      log         info: 99");
}

TEST(Thoughts, leave_out_what_is_for_coverage) {
  Thoughts thoughts;
  thoughts.note({InspectionKind::branch, "s", "a.xml:3", ""});
  EXPECT_THAT(thoughts.lines(), IsEmpty());
}

} // namespace
} // namespace parlour::tools
