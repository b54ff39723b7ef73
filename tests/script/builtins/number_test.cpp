#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinsNumber, Abs) {
  test::expect_rows({
      {"abs(-3)", "3"},
      {"abs(2.5)", "2.5"},
      {"abs(' -4 ')", "4"},
      {"type(abs(0))", "integer"},
      {"abs(-9223372036854775808)", "9223372036854776000"},
      {"type(abs(-9223372036854775808))", "number"},
      {"abs('x')", "Type: abs: argument 1 must be a number, not a string"},
      {"abs(unknown)", "Type: abs: argument 1 must be a number, not unknown"},
      {"abs(true)", "Type: abs: argument 1 must be a number, not a boolean"},
  });
}

TEST(BuiltinsNumber, MinAndMax) {
  test::expect_rows({
      {"min(3, 1, 2)", "1"},
      {"max(3, 1.5)", "3"},
      {"max([3, 9, 2])", "9"},
      {"min('b', 'a')", "a"},
      {"min('10', 9)", "9"},
      {"min([])", "unknown"},
      {"max([7])", "7"},
      {"min(7)", "Type: min: argument 1 must be a list, not an integer"},
      {"max(1, [2])",
       "Type: max: only numbers or strings have an order, not a list"},
      {"min(unknown, 2)",
       "Type: min: only numbers or strings have an order, not unknown"},
  });
}

TEST(BuiltinsNumber, Rounding) {
  test::expect_rows({
      {"floor(-1.5)", "-2"},
      {"ceil(-1.5)", "-1"},
      {"ceil(1.2)", "2"},
      {"round(2.5)", "3"},
      {"round(-2.5)", "-3"},
      {"round(2.4999)", "2"},
      {"type(round(2.4))", "integer"},
      {"floor(7)", "7"},
      {"floor('1.9')", "1"},
      {"round(1e30)", "1e+30"},
      {"floor([])", "Type: floor: argument 1 must be a number, not a list"},
      {"ceil('a')", "Type: ceil: argument 1 must be a number, not a string"},
      {"round({})", "Type: round: argument 1 must be a number, not a map"},
  });
}

TEST(BuiltinsNumber, RootsAndPowers) {
  test::expect_rows({
      {"sqrt(9)", "3"},
      {"sqrt(2)", "1.4142135623730951"},
      {"sqrt(0)", "0"},
      {"sqrt(-1)", "Arithmetic: sqrt: a negative number has no root"},
      {"sqrt('x')", "Type: sqrt: argument 1 must be a number, not a string"},
      {"pow(2, 10)", "1024"},
      {"type(pow(2, 10))", "integer"},
      {"pow(2, -1)", "0.5"},
      {"pow(2, 0.5)", "1.4142135623730951"},
      {"pow(0, 0)", "1"},
      {"type(pow(10, 30))", "number"},
      {"pow(10, 400)", "Arithmetic: pow: the result is not a number"},
      {"pow(-1, 0.5)", "Arithmetic: pow: the result is not a number"},
      {"pow(1, [])", "Type: pow: argument 2 must be a number, not a list"},
  });
}

TEST(BuiltinsNumber, Random) {
  test::expect_rows({
      {"random(3, 3)", "3"},
      {"random() < 1 and random() >= 0", "true"},
      {"random(1, 6) in range(1, 6)", "true"},
      {"random(-2, -1) < 0", "true"},
      {"random(6, 1)", "Range: random: the first end is above the second"},
      {"random(6)", "Type: random: give both ends, or none"},
      {"random(1.5, 2)",
       "Type: random: argument 1 must be an integer, not a number"},
      {"random('a', 2)",
       "Type: random: argument 1 must be an integer, not a string"},
  });
}

TEST(BuiltinsNumber, NumberAndInteger) {
  test::expect_rows({
      {"number('1.5')", "1.5"},
      {"number(' 12 ')", "12"},
      {"number('1e3')", "1000"},
      {"number('abc')", "unknown"},
      {"number('')", "unknown"},
      {"number('0x10')", "unknown"},
      {"number('inf')", "unknown"},
      {"number([1])", "unknown"},
      {"number(unknown)", "unknown"},
      {"integer('-2.7')", "-2"},
      {"integer(3.9)", "3"},
      {"integer('abc')", "unknown"},
      {"type(integer(2.0))", "integer"},
      {"integer('9223372036854775807')", "9223372036854775807"},
  });
}

TEST(BuiltinsNumber, TypesAndAgents) {
  test::expect_rows({
      {"type(true)", "boolean"},
      {"type(1)", "integer"},
      {"type(1.5)", "number"},
      {"type('')", "string"},
      {"type([])", "list"},
      {"type({})", "map"},
      {"type(unknown)", "unknown"},
      {"isknown(unknown)", "false"},
      {"isknown('')", "true"},
      {"online('Robot')", "false"}, // no agents in `exec`
      {"online([])", "Type: online: argument 1 must be a string, not a list"},
  });
}

} // namespace

} // namespace parlour::script
