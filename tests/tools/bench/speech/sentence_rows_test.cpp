#include <gtest/gtest.h>

#include "runtime/message/understanding.hpp"
#include "tools/bench/speech/sentence_rows.hpp"

namespace parlour::tools {
namespace {

List acts(const Value& host) {
  return {Map{{act_key::slots, Map{{"Host", host}}}}};
}

TEST(NameOutcome, is_right_asked_wrong_or_nothing) {
  EXPECT_EQ(name_outcome(acts(Map{{"value", "Ann Lee"}}), "Ann Lee"),
            NameOutcome::right);
  EXPECT_EQ(name_outcome(acts(Map{{"value", "Ann Lim"}}), "Ann Lee"),
            NameOutcome::wrong);
  const List two{"Ann Lim", "Ann Lee"};
  EXPECT_EQ(name_outcome(acts(Map{{"candidates", two}}), "Ann Lee"),
            NameOutcome::asked);
  EXPECT_EQ(name_outcome(acts(Map{{"candidates", two}}), "Bob Lee"),
            NameOutcome::wrong);
  EXPECT_EQ(name_outcome(acts(Map{{"unmatched", true}}), "Ann Lee"),
            NameOutcome::nothing);
  EXPECT_EQ(name_outcome({}, "Ann Lee"), NameOutcome::nothing);
  EXPECT_EQ(name_outcome({Map{{"act", "confirm"}}}, "Ann Lee"),
            NameOutcome::nothing);
}

} // namespace
} // namespace parlour::tools
