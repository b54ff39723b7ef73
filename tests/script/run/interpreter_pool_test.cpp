#include <gtest/gtest.h>

#include "script/program/computing_host.hpp"
#include "script/run/interpreter_pool.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

// What the function `main` gives.
std::string result_of(const std::string& declarations) {
  const auto outcome = test::compile_declarations(declarations);
  if (!outcome.program)
    return outcome.lines.empty() ? "" : outcome.lines[0];
  const InterpreterPool pool(outcome.program);
  ComputingHost host("a test", 0);
  std::string all;
  for (int time = 0; time < 2; ++time) {
    const auto value =
        pool.evaluate(outcome.program->functions.at("main"), {}, {}, host);
    all += (value ? value->text() : value.error().message) + " ";
  }
  return all;
}

TEST(InterpreterPool, KnowsConstants) {
  EXPECT_EQ(result_of("<const name='c' expr='2'/><const name='d' expr='c + 1'/>"
                      "<function name='main'><return expr='d'/></function>"),
            "3 3 ");
}

// What fails, or does more than compute, is the session's matter.
TEST(InterpreterPool, KnowsThoseBehindOneThatFails) {
  EXPECT_EQ(result_of("<var name='a' expr='1 / 0'/><const name='c' expr='2'/>"
                      "<function name='main'><return expr='c'/></function>"),
            "2 2 ");
}

TEST(InterpreterPool, OnlyComputes) {
  EXPECT_EQ(result_of("<function name='main'><speak param='x'/></function>"),
            "a test can only compute a test can only compute ");
}

} // namespace

} // namespace parlour::script
