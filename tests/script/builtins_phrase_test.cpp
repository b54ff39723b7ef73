#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinsPhrase, Count) {
  test::expect_rows({
      {"count(2, 'coffee shop')", "two coffee shops"},
      {"count(1, 'food court')", "one food court"},
      {"count(0, 'facility')", "no facilities"},
      {"count(3, 'toy')", "three toys"},
      {"count(4, 'box')", "four boxes"},
      {"count(5, 'staff')", "five staff"},
      {"count(6, 'tall person')", "six tall people"},
      {"count(42, 'match')", "forty two matches"},
      {"count(100, 'day')", "100 days"},
      {"count(2, 'is', 'are')", "two are"},
      {"count('x', 'day')",
       "Type: count: argument 1 must be an integer, not a string"},
      {"count(1, [])", "Type: count: argument 2 must be a string, not a list"},
      {"count(2, 'a', {})",
       "Type: count: argument 3 must be a string, not a map"},
  });
}

TEST(BuiltinsPhrase, Ordinal) {
  test::expect_rows({
      {"ordinal(1)", "first"},
      {"ordinal(12)", "twelfth"},
      {"ordinal(20)", "twentieth"},
      {"ordinal(23)", "twenty third"},
      {"ordinal(101)", "101st"},
      {"ordinal(112)", "112th"},
      {"ordinal(-2)", "-2nd"},
      {"ordinal('a')",
       "Type: ordinal: argument 1 must be an integer, not a string"},
  });
}

TEST(BuiltinsPhrase, List) {
  test::expect_rows({
      {"list(['A', 'B', 'C'])", "A, B and C"},
      {"list(['A', 'B'], 'or')", "A or B"},
      {"list([1])", "1"},
      {"list([])", ""},
      {"list(unknown)", ""},
      {"list('A')", "Type: list: argument 1 must be a list, not a string"},
      {"list([], [])", "Type: list: argument 2 must be a string, not a list"},
  });
}

TEST(BuiltinsPhrase, An) {
  test::expect_rows({
      {"an('apple')", "an apple"},
      {"an('Ice cream')", "an Ice cream"},
      {"an('pear')", "a pear"},
      {"an([])", "Type: an: argument 1 must be a string, not a list"},
  });
}

TEST(BuiltinsPhrase, Spoken) {
  test::expect_rows({
      {"spoken(1, 'level')", "the first floor"},
      {"spoken(0, 'level')", "the ground floor"},
      {"spoken(-1, 'level')", "basement one"},
      {"spoken('roof', 'level')", "roof"},
      {"spoken('10:30', 'time')", "10:30am"},
      {"spoken('00:05:00', 'time')", "12:05am"},
      {"spoken('15:00', 'time')", "3pm"},
      {"spoken('25:00', 'time')", "25:00"},
      {"spoken('2026-11-21', 'date')", "Saturday, 21 November"},
      {"spoken('soon', 'date')", "soon"},
      {"spoken(12, 'number')", "twelve"},
      {"spoken(1.5, 'number')", "1.5"},
      {"spoken(['A', 'B'], 'set')", "A and B"},
      {"spoken(unknown, 'time')", ""},
      {"spoken('x')", "x"},
      {"spoken({}, 'set')",
       "Type: spoken: argument 1 must be a string, not a map"},
  });
}

} // namespace

} // namespace parlour::script
