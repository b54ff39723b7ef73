#include <gtest/gtest.h>

#include "tests/script/script_run.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

// Stopped where one activation waits, another has yielded, and a timer is set.
class ExecStateTest : public testing::Test {
protected:
  void SetUp() override {
    const auto outcome = test::compile_declarations(
        "<function name='main'><var name='n' expr='5'/>"
        "<timer name='t' after='1s'><print param='{n}'/>"
        "<for name='i' from='1' to='9'/><print param='end'/></timer>"
        "<timer name='u' after='3s' repeat='true'><cancel timer='u'/></timer>"
        "<wait for='2s'/><print param='{random()}'/></function>");
    ASSERT_TRUE(outcome.program);
    program = outcome.program;
    options = stage.options(1000, {});
    run = std::make_unique<ExecRun>(program, options);
    run->set_slice(3);
    while (stage.printed.empty())
      ASSERT_TRUE(run->step());
    bytes = run->save();
  }
  std::string error_of(const std::string& damaged) {
    const auto restored = ExecRun::restore(program, options, damaged);
    return restored ? "restored" : restored.error().message;
  }

  std::shared_ptr<const Program> program;
  test::Stage stage;
  ExecOptions options;
  std::unique_ptr<ExecRun> run;
  std::string bytes;
};

TEST_F(ExecStateTest, EverythingDueComesInItsTime) {
  auto restored = ExecRun::restore(program, options, bytes);
  ASSERT_TRUE(restored) << restored.error().message;
  const auto before = stage;
  while (run->step()) {
  }
  const auto after = stage;
  stage = before;
  while ((*restored)->step()) {
  }
  EXPECT_EQ(after.printed, stage.printed);
  EXPECT_EQ(after.clock, stage.clock);
  EXPECT_EQ(stage.printed.substr(0, 6), "5\nend\n");
  EXPECT_EQ(stage.clock - test::Stage().clock, 3000);
  EXPECT_EQ(run->save(), (*restored)->save());
}

// What was taken beyond a slice counts, wherever the slice began.
TEST(ExecStateLimitsTest, TheSameLimitEndsARunWhereverItIsRestored) {
  const auto outcome = test::compile_declarations(
      "<function name='main'><var name='l' expr=\"['a text, said']\"/>"
      "<for name='i' from='1' to='12'><set name='l' expr='[l, l]'/></for>"
      "<print param='{l}'/></function>");
  ASSERT_TRUE(outcome.program);
  for (std::uint64_t fuel = 2000; fuel < 4000; fuel += 200)
    EXPECT_EQ(test::run_script(outcome.program, fuel).errors,
              test::run_with_restores(outcome.program, fuel).errors)
        << fuel;
}

TEST_F(ExecStateTest, WhatIsNoRunIsRefused) {
  EXPECT_NE(error_of("").find("byte 0"), std::string::npos) << error_of("");
  EXPECT_NE(error_of("<dialogue/>").find("another version"), std::string::npos);
  EXPECT_EQ(error_of(bytes), "restored");
  EXPECT_NE(error_of(bytes + "x").find("more follows"), std::string::npos);
}

TEST_F(ExecStateTest, DamagedBytesNeverCrash) {
  int refused = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(error_of(bytes.substr(0, size)), "restored") << size;
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const int change : {1, 2, 4, 64, 128, 255}) {
      auto damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ change);
      auto restored = ExecRun::restore(program, options, damaged);
      if (!restored)
        ++refused;
      for (int i = 0; restored && i < 20; ++i)
        (*restored)->step();
    }
  EXPECT_GT(refused, 200);
}

} // namespace

} // namespace parlour::script
