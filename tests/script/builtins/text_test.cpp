#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinsText, UpperAndLower) {
  test::expect_rows({
      {"upper('straße')", "STRASSE"},
      {"lower('ÉCOLE')", "école"},
      {"upper(true)", "TRUE"},
      {"upper(1.5)", "1.5"},
      {"lower('')", ""},
      {"upper([1])", "Type: upper: argument 1 must be a string, not a list"},
      {"lower(unknown)",
       "Type: lower: argument 1 must be a string, not unknown"},
  });
}

TEST(BuiltinsText, Trim) {
  test::expect_rows({
      {"'<' + trim(' \\t a b \\n') + '>'", "<a b>"},
      {"length(trim('   '))", "0"},
      {"trim(12)", "12"},
      {"trim({})", "Type: trim: argument 1 must be a string, not a map"},
  });
}

TEST(BuiltinsText, Substring) {
  test::expect_rows({
      {"substring('héllo', 1, 3)", "éll"},
      {"substring('hello', 3)", "lo"},
      {"substring('hello', -3)", "llo"},
      {"substring('hello', 3, 99)", "lo"},
      {"substring('hello', 9)", ""},
      {"substring('hello', 1, -1)", ""},
      {"substring(12345, 1, 2)", "23"},
      {"substring('a', 'b')",
       "Type: substring: argument 2 must be an integer, not a string"},
      {"substring('a', 0, 0.5)",
       "Type: substring: argument 3 must be an integer, not a number"},
      {"substring([], 0)",
       "Type: substring: argument 1 must be a string, not a list"},
  });
}

TEST(BuiltinsText, Find) {
  test::expect_rows({
      {"find('hello', 'l')", "2"},
      {"find('hello', 'l', 3)", "3"},
      {"find('hello', 'x')", "-1"},
      {"find('éa', 'a')", "1"},
      {"find('abc', '')", "0"},
      {"find('aXa', 'a', -1)", "2"},
      {"find(unknown, 'a')",
       "Type: find: argument 1 must be a string, not unknown"},
      {"find('a', [])", "Type: find: argument 2 must be a string, not a list"},
  });
}

TEST(BuiltinsText, Replace) {
  test::expect_rows({
      {"replace('a-b-c', '-', '+')", "a+b+c"},
      {"replace('aaa', 'aa', 'b')", "ba"},
      {"replace('abc', '', 'x')", "abc"},
      {"replace('a1b', 1, 2)", "a2b"},
      {"replace('abc', 'b', '')", "ac"},
      {"replace('abc', 'b', [])",
       "Type: replace: argument 3 must be a string, not a list"},
  });
}

TEST(BuiltinsText, SplitAndJoin) {
  test::expect_rows({
      {"split(' a b  c ')", "[a, b, c]"},
      {"split('')", "[]"},
      {"split('a,b,,c', ',')", "[a, b, , c]"},
      {"length(split('', ','))", "1"},
      {"split('hé', '')", "[h, é]"},
      {"split([])", "Type: split: argument 1 must be a string, not a list"},
      {"join([1, 'b', true], '-')", "1-b-true"},
      {"join(['a', 'b'])", "ab"},
      {"join([], '-')", ""},
      {"join([[1], unknown], ';')", "[1];unknown"},
      {"join('ab', '-')",
       "Type: join: argument 1 must be a list, not a string"},
      {"join([], [])", "Type: join: argument 2 must be a string, not a list"},
  });
}

TEST(BuiltinsText, BeginningsAndEnds) {
  test::expect_rows({
      {"startswith('abc', 'ab')", "true"},
      {"startswith('abc', 'b')", "false"},
      {"startswith('abc', '')", "true"},
      {"endswith('abc', 'bc')", "true"},
      {"endswith(105, 5)", "true"},
      {"startswith([], 'a')",
       "Type: startswith: argument 1 must be a string, not a list"},
      {"endswith('a', unknown)",
       "Type: endswith: argument 2 must be a string, not unknown"},
  });
}

TEST(BuiltinsText, String) {
  test::expect_rows({
      {"string(0.5)", "0.5"},
      {"string(2.0)", "2"},
      {"string(unknown)", "unknown"},
      {"string([1, 'a', {'k': 2.5}])", "[1, a, {k: 2.5}]"},
      {"type(string(1))", "string"},
  });
}

} // namespace

} // namespace parlour::script
