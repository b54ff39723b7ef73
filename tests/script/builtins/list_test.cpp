#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinsList, Length) {
  test::expect_rows({
      {"length('héllo')", "5"},
      {"length([1, 2])", "2"},
      {"length({'a': 1})", "1"},
      {"length(unknown)", "0"},
      {"length(-12)", "3"},
      {"length(true)", "4"},
  });
}

TEST(BuiltinsList, Contains) {
  test::expect_rows({
      {"contains('abc', 'b')", "true"},
      {"contains('a5', 5)", "true"},
      {"contains([1, 2], '2')", "true"},
      {"contains({'k': 1}, 'k')", "true"},
      {"contains(unknown, 1)", "false"},
      {"contains(5, 5)",
       "Type: contains: argument 1 must be a string, list or map, "
       "not an integer"},
  });
}

TEST(BuiltinsList, Changing) {
  test::expect_rows({
      {"append([1], 2)", "[1, 2]"},
      {"insert([1, 3], 1, 2)", "[1, 2, 3]"},
      {"insert([1], 1, 2)", "[1, 2]"},
      {"remove([1, 2, 3], 1)", "2"},
      {"remove([1, 2, 3], -1)", "3"},
      {"remove({'a': 1}, 'a')", "1"},
      {"remove({'a': 1}, 'b')", "unknown"},
      {"reverse([1, 2])", "[2, 1]"},
      {"append('a', 1)",
       "Type: append: argument 1 must be a list, not a string"},
      {"insert([1], 5, 2)",
       "Range: insert: position 5 is outside of a list of 1"},
      {"remove([1], 1)", "Range: remove: position 1 is outside of a list of 1"},
      {"remove('a', 0)",
       "Type: remove: argument 1 must be a list, not a string"},
      {"reverse('ab')",
       "Type: reverse: argument 1 must be a list, not a string"},
  });
}

TEST(BuiltinsList, Sort) {
  test::expect_rows({
      {"sort([3, 1.5, 2])", "[1.5, 2, 3]"},
      {"sort(['b', 'B', 'a'])", "[B, a, b]"},
      {"sort(['10', '9'])", "[10, 9]"},
      {"sort([1, 3, 2], 'descending')", "[3, 2, 1]"},
      {"sort([])", "[]"},
      {"sort([1, 'a'])", "Type: sort: only numbers with numbers or strings "
                         "with strings can be sorted"},
      {"sort([1], 'up')",
       "Type: sort: the order is 'ascending' or 'descending', not 'up'"},
      {"sort('ab')", "Type: sort: argument 1 must be a list, not a string"},
  });
}

TEST(BuiltinsList, IndexOfSliceFirstLast) {
  test::expect_rows({
      {"indexof([1, 2], '2')", "1"},
      {"indexof([1], 3)", "-1"},
      {"indexof(unknown, 3)", "-1"},
      {"indexof('ab', 'b')",
       "Type: indexof: argument 1 must be a list, not a string"},
      {"slice([1, 2, 3], 1)", "[2, 3]"},
      {"slice([1, 2, 3], 0, -1)", "[1, 2]"},
      {"slice('héllo', 1, 3)", "él"},
      {"slice([1], 5)", "[]"},
      {"slice(5, 0)",
       "Type: slice: argument 1 must be a list or string, not an integer"},
      {"first([1, 2])", "1"},
      {"last([1, 2])", "2"},
      {"first([])", "unknown"},
      {"last(unknown)", "unknown"},
      {"first({})", "Type: first: argument 1 must be a list, not a map"},
  });
}

TEST(BuiltinsList, Range) {
  test::expect_rows({
      {"range(1, 3)", "[1, 2, 3]"},
      {"range(3, 1)", "[]"},
      {"range(3, 1, -1)", "[3, 2, 1]"},
      {"range(0, 1, 0.5)", "[0, 0.5, 1]"},
      {"range(1, 2, 0)", "[]"},
      {"range('a', 2)",
       "Type: range: argument 1 must be a number, not a string"},
  });
}

TEST(BuiltinsList, Maps) {
  test::expect_rows({
      {"keys({'b': 1, 'a': 2})", "[b, a]"},
      {"values({'b': 1, 'a': 2})", "[1, 2]"},
      {"has({'b': unknown}, 'b')", "true"},
      {"has({}, 'b')", "false"},
      {"has(unknown, 'b')", "false"},
      {"keys([1])", "Type: keys: argument 1 must be a map, not a list"},
      {"values(1)", "Type: values: argument 1 must be a map, not an integer"},
      {"has([], 'a')", "Type: has: argument 1 must be a map, not a list"},
      {"column(unknown, 'a')", "[]"},
      {"column([], 'a')",
       "Type: column: argument 1 must be a result, not a list"},
  });
}

} // namespace

} // namespace parlour::script
