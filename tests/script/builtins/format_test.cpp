#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinsFormat, Places) {
  test::expect_rows({
      {"format('{} of {}', 2, [1])", "2 of [1]"},
      {"format('{{}} {}', 'x')", "{} x"},
      {"format('{{:5}} {x}')", "{:5} {x}"},
      {"format('none')", "none"},
      {"format('{}', 1, 2)", "1"},
      {"format('{} ' + '{}', 1)",
       "Range: format: the pattern has more {} than there are arguments"},
      {"format([])", "Type: format: argument 1 must be a string, not a list"},
  });
}

TEST(BuiltinsFormat, Padding) {
  test::expect_rows({
      {"format('{:5}|{:5}|', 7, 'é')", "    7|é    |"},
      {"format('{:<5}|{:>5}|{:^5}|', 7, 'é', 'ab')", "7    |    é| ab  |"},
      {"format('{:*^6}{:–>3}', 'ab', 1)", "**ab**––1"},
      {"format('{:05} {:05} {:+05}', 42, -42, '42')", "00042 -0042 +0042"},
      {"format('{:2}', 'longer')", "longer"},
      {"format('{:8}|', unknown)", "unknown |"},
  });
}

TEST(BuiltinsFormat, Numbers) {
  test::expect_rows({
      {"format('{:.2}', 2)", "2.00"},
      {"format('{:.2} {:.2}', 2.675, -0.001)", "2.68 0.00"},
      {"format('{:.0} {:.0} {:.1}', 2.5, 0.4, 9.95)", "3 0 10.0"},
      {"format('{:,} {:,.2} {:,}', 1234567, 1234.5, -999)",
       "1,234,567 1,234.50 -999"},
      {"format('{:10,.2}|', 1234.5)", "  1,234.50|"},
      {"format('{} {:.2}', 1e300, '3.14159')", "1e+300 3.14"},
      {"format('{:.2}', 'a')",
       "Type: format: the pattern wants a number, not a string"},
  });
}

TEST(BuiltinsFormat, Letters) {
  test::expect_rows({
      {"format('{:u} {:l} {:c}', 'straße', 'ABC', 'émile zola')",
       "STRASSE abc Émile zola"},
      {"format('{:>6u}', 'ab')", "    AB"},
      {"format('{:c}|', '')", "|"},
  });
}

TEST(BuiltinsFormat, WrongPatterns) {
  test::expect_rows({
      {"format('{:' + 'x}', 1)",
       "Range: format: '{:x}' is no format; write for example {:05} {:>8} "
       "{:.2} {:,} {:u}, and {{ for a brace"},
      {"format('{:' + '2000}', 1)",
       "Range: format: '{:2000}' is wider than 1000"},
      {"format('{:' + '.99}', 1)",
       "Range: format: '{:.99}' has more than 20 decimals"},
  });
}

} // namespace

} // namespace parlour::script
