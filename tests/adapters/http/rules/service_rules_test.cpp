#include "adapters/http/rules/service_rules.hpp"
#include "tests/adapters/http/rules/rules_fixture.hpp"

namespace parlour::adapters::http {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr auto taxi = "<command name='Book'><get url='/'/>"
                      "<on><event name='Booked'><param value='{/a}'/>"
                      "<param value='5'/></event></on></command>";
constexpr auto own = "<command name='Cancel' params='plate, why?'>"
                     "<delete url='/{plate}'/><on><event name='Gone'>"
                     "<param value='{plate}'/></event></on>"
                     "<otherwise><event name='Failed'>"
                     "<param value='no'/></event></otherwise></command>";

TEST(ServiceRules, HaveTheirCommands) {
  const auto rules = rules_of(taxi, "Taxi");
  ASSERT_TRUE(rules.find("Book"));
  EXPECT_EQ(rules.find("Book")->parameters.size(), 4u); // those of the role
  EXPECT_EQ(rules.find("Cancel"), nullptr);
}

TEST(ServiceRules, RefuseAsTheirRoleDoes) {
  EXPECT_EQ(rules_of(taxi, "Taxi").refusal(), "Refused");
  EXPECT_EQ(rules_of(own).refusal(), "Failed");
}

TEST(ServiceRules, WhatIsReportedEndsNoRequest) {
  const auto events = own_events(
      rules_of(std::string(own) + "<webhook path='/a'><on has='/x'>"
                                  "<event name='Gone'/></on>"
                                  "<on><event name='Late'/></on></webhook>"));
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_EQ(events[0].reply, Reply::answer); // a command has it, too
  EXPECT_EQ(events[1].name, "Late");
  EXPECT_EQ(events[1].reply, Reply::none);
}

TEST(ServiceRules, DescribeWhatTheRoleLacks) {
  const auto rules = rules_of(std::string(taxi) + own, "Taxi");
  const auto commands = own_commands(rules);
  ASSERT_THAT(commands, SizeIs(1));
  EXPECT_EQ(commands[0].name, "Cancel");
  EXPECT_EQ(commands[0].parameters, "plate, why?");
  const auto events = own_events(rules);
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_EQ(events[0].name, "Gone");
  EXPECT_EQ(events[0].parameters, "value1");
  EXPECT_EQ(events[0].reply, Reply::answer);
  EXPECT_THAT(own_events(rules_of(taxi, "Taxi")), IsEmpty());
}

} // namespace
} // namespace parlour::adapters::http
