#include <gtest/gtest.h>

#include "script/compiler/code/expressions/literal_arguments.hpp"

namespace parlour::script {

namespace {

// "index: message", or nothing.
std::string wrong_in(const char* call) {
  const auto parsed = parse_expression(call);
  const auto wrong = wrong_argument(*parsed.node);
  return wrong ? std::to_string(wrong->index) + ": " + wrong->message : "";
}

TEST(LiteralArguments, OfFormat) {
  EXPECT_EQ(wrong_in("format('{} {:05}', a, b)"), "");
  EXPECT_EQ(wrong_in("format('{} {}', a)"),
            "0: the pattern has 2 places, but 1 value follows");
  EXPECT_EQ(wrong_in("format('{}')"),
            "0: the pattern has 1 place, but 0 values follow");
  EXPECT_EQ(wrong_in("format('{:q}', a)").substr(0, 24),
            "0: '{:q}' is no format; ");
  EXPECT_EQ(wrong_in("format(a)"), "");
}

TEST(LiteralArguments, OfSpeaking) {
  EXPECT_EQ(wrong_in("spoken(a, 'time')"), "");
  EXPECT_EQ(wrong_in("spoken(a, kind)"), "");
  EXPECT_EQ(wrong_in("spoken(a)"), "");
  EXPECT_EQ(wrong_in("spoken(a, 'tiem')"),
            "1: nothing is spoken as 'tiem', did you mean 'time'?");
  EXPECT_EQ(wrong_in("list(a, 'or', 'dates')"),
            "2: nothing is spoken as 'dates', did you mean 'date'?");
  EXPECT_EQ(wrong_in("list(a, 'dates')"), "");
}

} // namespace

} // namespace parlour::script
