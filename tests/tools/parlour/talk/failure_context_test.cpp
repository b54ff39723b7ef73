#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/talk/failure_context.hpp"

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

TEST(FailureContext, tell_what_was_understood) {
  FailureContext context;
  context.note(message("FrameInfo", {taxi(), Map{{"act", "thank"}}}));
  EXPECT_THAT(context.lines(),
              ElementsAre("understood  inform Taxi (0.95): Time = 15:00, "
                          "Place = [A, B]",
                          "understood  thank"));
  context.begin_turn();
  context.note(message("NoResult", {"hm"}));
  EXPECT_THAT(context.lines(), ElementsAre("understood  nothing"));
}

TEST(FailureContext, tell_where_the_dialogue_stands) {
  FailureContext context;
  context.note({InspectionKind::transition, "s", "Welcome", "from ''"});
  context.note({InspectionKind::topic, "s", "Taxi", "active"});
  context.note({InspectionKind::slot, "s", "Taxi.Time", "3pm (accepted)"});
  context.begin_turn();
  context.note({InspectionKind::slot, "s", "Taxi.Time", "4pm (accepted)"});
  EXPECT_THAT(context.lines(),
              ElementsAre("state       Welcome",
                          "topic       Taxi active: Time = 4pm (accepted)",
                          "before      slot        Taxi.Time: 4pm (accepted)"));
}

TEST(FailureContext, are_about_the_recent_past) {
  FailureContext context;
  for (int i = 0; i < 100; ++i)
    context.note({InspectionKind::log, "s", "info", std::to_string(i)});
  EXPECT_EQ(context.lines().size(), 12u);
  EXPECT_EQ(context.lines().back(), "before      log         info: 99");
}

TEST(FailureContext, leave_out_what_is_for_coverage) {
  FailureContext context;
  context.note({InspectionKind::branch, "s", "a.xml:3", ""});
  EXPECT_THAT(context.lines(), IsEmpty());
}

} // namespace
} // namespace parlour::tools
