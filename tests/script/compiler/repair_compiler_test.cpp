#include <gmock/gmock.h>

#include "script/compiler/repair_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::Contains;
using testing::HasSubstr;

TEST(RepairCompiler, the_application_s_come_before_the_platform_s) {
  const auto outcome = test::compile_declarations(
      "<topic name='t'><slot name='s'/></topic>"
      "<repair act='help, explain' topic='t' slot='s' if='data.asked'>"
      "<speak param='{this.s}'/></repair>"
      "<repair act='no_match' count='2'/>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& repairs = outcome.program->repairs;
  ASSERT_GT(repairs.size(), 10u);
  EXPECT_EQ(repairs[0].act, "help");
  EXPECT_EQ(repairs[1].act, "explain");
  EXPECT_EQ(repairs[1].topic, 0u);
  EXPECT_EQ(repairs[1].slot, 0u);
  EXPECT_NE(repairs[1].condition, no_code);
  EXPECT_FALSE(repairs[1].of_platform);
  EXPECT_EQ(repairs[2].count, 2u);
  EXPECT_TRUE(repairs[3].of_platform);
}

TEST(RepairCompiler, the_platform_has_one_for_every_act_about_itself) {
  const auto outcome = test::compile_declarations("");
  ASSERT_TRUE(outcome.program);
  std::vector<std::string> acts;
  for (const auto& repair : outcome.program->repairs)
    acts.push_back(repair.act);
  for (const auto* act :
       {"help", "explain", "options", "rephrase", "repeat", "cancel", "abandon",
        "restart", "person", "greet", "thank", "bye", "correct", "no_match",
        "no_input", "wait", "protest", "refuse"})
    EXPECT_THAT(acts, Contains(act));
}

TEST(RepairCompiler, checks_its_names) {
  const auto outcome = test::compile_declarations(
      "<topic name='Taxi'><slot name='Time'/></topic>"
      "<repair act='halp'/><repair act='help' topic='Taxy'/>"
      "<repair act='help' topic='Taxi' slot='Tim'/>"
      "<repair act='help' slot='Time'/>");
  EXPECT_FALSE(outcome.program);
  EXPECT_THAT(outcome.lines, Contains(HasSubstr("did you mean 'help'")));
  EXPECT_THAT(outcome.lines, Contains(HasSubstr("did you mean 'Taxi'")));
  EXPECT_THAT(outcome.lines, Contains(HasSubstr("did you mean 'Time'")));
  EXPECT_THAT(outcome.lines, Contains(HasSubstr("needs its 'topic'")));
}

} // namespace parlour::script
