#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/status/status_report.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

StatusReport report() {
  StatusReport made{"desk", "/apps/desk", 42, 10'000, {}};
  actors::ActorStatus ear;
  ear.kind = "component_host";
  ear.name = "Ear";
  ear.doing = "does not answer";
  ear.queue = 3;
  ear.last_error = "no device";
  ear.call_since = 8'500;
  ear.answered = false;
  made.actors.push_back(ear);
  return made;
}

TEST(StatusReport, IsReadAsItWasWritten) {
  const auto read = report_from_json(to_json(report()));
  ASSERT_TRUE(read);
  EXPECT_EQ(to_json(*read), to_json(report()));
  EXPECT_EQ(read->actors.at(0).call_since, 8'500);
  EXPECT_EQ(read->process, 42);
}

TEST(StatusReport, WhatIsNoneIsAnError) {
  for (const auto* text : {"", "{}", "[]", "{\"application\": 7}"})
    EXPECT_FALSE(report_from_json(text)) << text;
}

TEST(StatusReport, IsATableForPeople) {
  std::ostringstream out;
  print_table(out, report());
  EXPECT_EQ(
      out.str(),
      "desk (process 42, /apps/desk)\n"
      "actor           name  queue  in a call  does             last error\n"
      "component_host  Ear   3      1500 ms    does not answer  no device\n");
}

TEST(StatusReport, AllAreOneArray) {
  std::ostringstream out;
  print_json(out, {report()});
  EXPECT_THAT(out.str(), HasSubstr("\"in_call_ms\": 1500"));
  EXPECT_EQ(out.str().front(), '[');
}

} // namespace
} // namespace parlour::tools
