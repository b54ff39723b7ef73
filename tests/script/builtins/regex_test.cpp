#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinsRegex, Matches) {
  test::expect_rows({
      {"matches('abc123', '[0-9]+')", "true"},
      {"matches('abc', '^b')", "false"},
      {"matches('É', '^.$')", "true"},
      {"matches('', '')", "true"},
      {"matches(105, '^1')", "true"},
      {"matches(unknown, 'a')", "false"},
      {"matches('a', '(')", "Type: matches: '(' is not a regular expression: "
                            "missing ): ("},
      {"matches([], 'a')",
       "Type: matches: argument 1 must be a string, not a list"},
      {"matches('a', [])",
       "Type: matches: argument 2 must be a string, not a list"},
  });
}

TEST(BuiltinsRegex, Capture) {
  test::expect_rows({
      {"capture('at 10:30', '([0-9]+):([0-9]+)')", "[10:30, 10, 30]"},
      {"capture('x', 'y')", "unknown"},
      {"capture('b', '(a)?b')", "[b, unknown]"},
      {"capture('ab', '(?i)B')", "[b]"},
      {"capture(unknown, 'a')", "unknown"},
      {"capture({}, 'a')",
       "Type: capture: argument 1 must be a string, not a map"},
      {"capture('a', '[')", "Type: capture: '[' is not a regular expression: "
                            "missing ]: ["},
  });
}

// Exponential for an expression that tries again from every place.
TEST(BuiltinsRegex, TakesTimeInProportionToTheText) {
  const std::string many = "replace(replace('aaaaaaaaaa', 'a', 'aaaaaaaaaa'), "
                           "'a', 'aaaaaaaaaa')";
  const auto found = "matches(" + many + ", '(a+)+$')";
  const auto sought = "matches(" + many + ", '(a+)+b$')";
  test::expect_rows({
      {"length(" + many + ")", "1000"},
      {found, "true"},
      {sought, "false"},
  });
}

} // namespace

} // namespace parlour::script
