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

// What one session's phrase sets is not what another one's reads.
TEST(InterpreterPool, ForgetsWhatAFunctionSets) {
  EXPECT_EQ(result_of("<var name='n' expr='0'/><function name='main'>"
                      "<set name='n' expr='n + 1'/><return expr='n'/>"
                      "</function>"),
            "1 1 ");
  EXPECT_EQ(
      result_of(
          "<var name='n' expr='0'/><function name='set'>"
          "<param name='x'/>"
          "<set name='x' expr='x + 1'/></function>"
          "<function name='main'><call function='set'><var expr='n'/></call>"
          "<return expr='n'/></function>"),
      "1 1 ");
}

TEST(InterpreterPool, ForgetsWhatAFunctionChangesInAList) {
  const auto twice = [](const std::string& change) {
    return result_of("<const name='l' expr='[2, 1]'/><function name='main'>"
                     "<var name='own' expr='l'/>" +
                     change + "<return expr='l'/></function>");
  };
  EXPECT_EQ(twice("<append name='own' expr='3'/>"), "[2, 1, 3] [2, 1, 3] ");
  EXPECT_EQ(twice("<set name='own[0]' expr='own[0] + 1'/>"), "[3, 1] [3, 1] ");
  for (const auto* change : {"append(l, 3)", "insert(l, 2, 3)"})
    EXPECT_EQ(twice("<set name='own' expr=\"" + std::string(change) + "\"/>"),
              "[2, 1, 3] [2, 1, 3] ");
  EXPECT_EQ(twice("<set name='own' expr='remove(l, 0)'/>"), "[1] [1] ");
  EXPECT_EQ(twice("<set name='own' expr='reverse(l)'/>"), "[1, 2] [1, 2] ");
}

// Not that of whoever came first.
TEST(InterpreterPool, KnowsTheTimeOfItsCaller) {
  const auto outcome = test::compile_declarations(
      "<const name='began' expr='now()'/>"
      "<function name='main'><return expr='began'/></function>");
  ASSERT_TRUE(outcome.program);
  const InterpreterPool pool(outcome.program);
  std::string times;
  for (const Timestamp now : {5, 7}) {
    ComputingHost host("a test", now);
    const auto code = outcome.program->functions.at("main");
    times += pool.evaluate(code, {}, {}, host)->text() + " ";
  }
  EXPECT_EQ(times, "0.005 0.007 ");
}

} // namespace

} // namespace parlour::script
