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
      {"count(100, 'day')", "one hundred days"},
      {"count(200000.0, 'euro')", "two hundred thousand euros"},
      {"count(2.5, 'hour')", "two point five hours"},
      {"count(-1, 'degree')", "minus one degree"},
      {"count(2, 'is', 'are')", "two are"},
      {"count('x', 'day')",
       "Type: count: argument 1 must be a number, not a string"},
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
      {"ordinal(101)", "one hundred and first"},
      {"ordinal(112)", "one hundred and twelfth"},
      {"ordinal(-2)", "minus second"},
      {"ordinal('a')",
       "Type: ordinal: argument 1 must be an integer, not a string"},
  });
}

TEST(BuiltinsPhrase, List) {
  test::expect_rows({
      {"list(['A', 'B', 'C'])", "A, B and C"},
      {"list(['A', 'B'], 'or')", "A or B"},
      {"list([1])", "1"},
      {"list(['10:30', '15:00'], 'or', 'time')", "10:30am or 3pm"},
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
      {"spoken(['A', 'B'], 'set')", "A and B"},
      {"spoken(['10:30', '15:00'], 'time')", "10:30am and 3pm"},
      {"spoken(unknown, 'time')", ""},
      {"spoken('x')", "x"},
      {"spoken('12')", "12"},
      {"spoken(12)", "twelve"},
      {"spoken(true)", "true"},
      {"spoken(5, 'num' + 'eral')", "5"},
      {"spoken({}, 'set')",
       "Type: spoken: argument 1 must be a string, not a map"},
  });
}

TEST(BuiltinsPhrase, SpokenLevels) {
  test::expect_rows({
      {"spoken(1, 'level')", "the first floor"},
      {"spoken(0, 'level')", "the ground floor"},
      {"spoken(-1, 'level')", "basement one"},
      {"spoken('roof', 'level')", "roof"},
  });
}

TEST(BuiltinsPhrase, SpokenNumbers) {
  test::expect_rows({
      {"spoken(12, 'number')", "twelve"},
      {"spoken('12', 'number')", "twelve"},
      {"spoken(0, 'number')", "zero"},
      {"spoken(-7, 'number')", "minus seven"},
      {"spoken(2.5, 'number')", "two point five"},
      {"spoken(-0.05, 'number')", "minus zero point zero five"},
      {"spoken(0.1 + 0.2, 'number')", "zero point three"},
      {"spoken(1938, 'number')", "one thousand nine hundred and thirty eight"},
      {"spoken(2e5, 'number')", "two hundred thousand"},
      {"spoken(1000005, 'number')", "one million and five"},
      {"spoken(-1200300, 'number')",
       "minus one million two hundred thousand three hundred"},
      {"spoken(3e15, 'number')", "3000000000000000"},
      {"spoken(3e-7, 'number')", "3e-7"},
      {"spoken('many', 'number')", "many"},
      {"spoken(12.345, 'amount')", "twelve point three five"},
      {"spoken(2, 'amount')", "two"},
      {"spoken(23, 'ordinal')", "twenty third"},
      {"spoken(2.5, 'ordinal')", "two point five"},
      {"spoken(1938, 'year')", "nineteen thirty eight"},
      {"spoken('2005', 'year')", "two thousand and five"},
      {"spoken(1905, 'year')", "nineteen oh five"},
      {"spoken(1900, 'year')", "nineteen hundred"},
      {"spoken('91234567', 'phone')",
       "nine one two three, four five six seven"},
      {"spoken('+65 9123', 'phone')", "plus six five, nine one two three"},
      {"spoken(1234, 'digits')", "one two three four"},
  });
}

TEST(BuiltinsPhrase, SpokenTimes) {
  test::expect_rows({
      {"spoken('10:30', 'time')", "10:30am"},
      {"spoken('00:05:00', 'time')", "12:05am"},
      {"spoken('15:00', 'time')", "3pm"},
      {"spoken('25:00', 'time')", "25:00"},
      {"spoken(5400, 'duration')", "one hour and thirty minutes"},
      {"spoken(90061, 'duration')",
       "one day, one hour, one minute and one second"},
      {"spoken(0, 'duration')", "zero seconds"},
      {"spoken(1.5, 'duration')", "one point five seconds"},
      {"spoken(600.0, 'duration')", "ten minutes"},
      {"spoken('long', 'duration')", "long"},
  });
}

// Said on 21 November 2026.
TEST(BuiltinsPhrase, SpokenDates) {
  test::expect_rows({
      {"spoken('2026-11-21', 'date')", "Saturday, 21 November"},
      {"spoken('2027-01-01', 'date')", "Friday, 1 January twenty twenty seven"},
      {"spoken('2026-01-02', 'date')", "2 January twenty twenty six"},
      {"spoken('1938-05-03', 'date')", "3 May nineteen thirty eight"},
      {"spoken('2026-02-30', 'date')", "2026-02-30"},
      {"spoken('soon', 'date')", "soon"},
  });
}

} // namespace

} // namespace parlour::script
