#include <gtest/gtest.h>

#include "script/run/exec_run.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

struct Execution {
  std::vector<std::string> printed;
  std::vector<std::string> logged;
  std::optional<ExecFailure> failure;
};

Execution execute(const std::string& declarations) {
  Execution execution;
  const auto outcome = test::compile_declarations(declarations);
  if (!outcome.program) {
    ADD_FAILURE() << outcome.lines[0];
    return execution;
  }
  Timestamp clock = 0;
  ExecOptions options;
  options.print = [&](auto text) { execution.printed.emplace_back(text); };
  options.log = [&](auto text) { execution.logged.emplace_back(text); };
  options.now = [&] { return clock; };
  options.wait_until = [&](Timestamp time) { clock = time; };
  options.instructions = 100'000;
  execution.failure = run_main(outcome.program, options);
  return execution;
}

TEST(Exec, PrintsAndLogsApart) {
  const auto execution = execute("<function name='main'><print param='out'/>"
                                 "<log param='note'/></function>");
  EXPECT_EQ(execution.printed, std::vector<std::string>{"out"});
  EXPECT_EQ(execution.logged, std::vector<std::string>{"note"});
  EXPECT_FALSE(execution.failure);
}

TEST(Exec, ARepeatedTimerEndsWhenItIsCancelled) {
  const auto execution =
      execute("<var name='n' expr='0'/><function name='main'>"
              "<timer name='t' after='1s' repeat='true'>"
              "<set name='n' expr='n + 1'/><print param='{n}'/>"
              "<if cond='n == 3'><cancel timer='t'/></if></timer></function>");
  EXPECT_EQ(execution.printed, (std::vector<std::string>{"1", "2", "3"}));
}

TEST(Exec, TimeEndsSomewhere) {
  const auto execution =
      execute("<function name='main'><for name='i' from='1' to='9'>"
              "<wait for='900000000000h'/></for><print param='end'/>"
              "</function>");
  EXPECT_FALSE(execution.failure);
  EXPECT_EQ(execution.printed, std::vector<std::string>{"end"});
}

TEST(Exec, WithoutMainThereIsNothingToRun) {
  EXPECT_TRUE(execute("<function name='other'/>").failure);
}

TEST(Exec, WhatNeedsAnApplicationIsRefused) {
  const auto execution = execute("<function name='main'>"
                                 "<fire event='e'/></function>");
  ASSERT_TRUE(execution.failure);
  EXPECT_EQ(execution.failure->error.kind, ErrorKind::refused);
  EXPECT_EQ(execution.failure->error.message,
            "<fire> needs a running application");
}

TEST(Exec, WithoutADataFolderThereAreNoFiles) {
  const auto execution = execute("<function name='main'>"
                                 "<deletefile name='a'/></function>");
  ASSERT_TRUE(execution.failure);
  EXPECT_EQ(execution.failure->error.kind, ErrorKind::refused);
  EXPECT_EQ(execution.failure->error.message,
            "<deletefile> needs a running application");
}

} // namespace

} // namespace parlour::script
