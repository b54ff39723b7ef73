#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinCall, TakesArgumentsByTypeAndNamesThoseThatDoNotFit) {
  test::expect_rows({
      {"upper(12)", "12"},
      {"upper(true)", "TRUE"},
      {"upper([])", "Type: upper: argument 1 must be a string, not a list"},
      {"abs('-2')", "2"},
      {"substring('abc', 1.0)", "bc"},
      {"substring('abc', 1.5)",
       "Type: substring: argument 2 must be an integer, not a number"},
      {"substring('abc', 'x')",
       "Type: substring: argument 2 must be an integer, not a string"},
      {"sort('abc')", "Type: sort: argument 1 must be a list, not a string"},
  });
}

} // namespace

} // namespace parlour::script
