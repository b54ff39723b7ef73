#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/process/child_process.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

constexpr Milliseconds patience{60'000};

std::unique_ptr<ChildProcess> shell(const std::string& script) {
  return ChildProcess::spawn("/bin/sh", {"-c", script}).value();
}

TEST(ChildProcess, SaysHowItEnded) {
  EXPECT_EQ(shell("exit 7")->bury(patience), "ended with status 7");
  EXPECT_EQ(shell("kill -TERM $$")->bury(patience),
            "was killed by signal 15 (Terminated)");
}

TEST(ChildProcess, EndsByForceWhatDoesNotEnd) {
  auto child = shell("kill -STOP $$");
  EXPECT_FALSE(child->has_ended());
  EXPECT_EQ(child->bury(Milliseconds(10)), "hung up and did not end");
}

TEST(ChildProcess, IsKilledAtAnyTime) {
  auto child = shell("kill -STOP $$");
  child->kill();
  child->wait();
  EXPECT_EQ(child->bury(patience), "was killed by signal 9 (Killed)");
  EXPECT_TRUE(child->has_ended());
  child->kill(); // nobody
}

TEST(ChildProcess, HasNothingOfOursButItsSocket) {
  const auto file = std::tmpfile(); // open without close-on-exec
  auto child = shell("for i in 4 5 6 7 8 9 10 11 12 13 14 15; do "
                     "test ! -e /proc/$$/fd/$i || exit 1; done; "
                     "test \"$(readlink /proc/$$/fd/0)\" = /dev/null");
  EXPECT_EQ(child->bury(patience), "ended with status 0");
  std::fclose(file);
}

TEST(ChildProcess, IsHeardWhenItPrints) {
  auto child = shell("echo one; echo two >&2");
  EXPECT_EQ(child->bury(patience), "ended with status 0");
  EXPECT_EQ(child->read_output(), "one\ntwo\n");
  EXPECT_EQ(child->read_output(), "");
}

TEST(ChildProcess, IsCalledParlour) {
  auto child = shell("tr '\\0' ' ' < /proc/$$/cmdline | grep -q '^parlour -c'");
  EXPECT_EQ(child->bury(patience), "ended with status 0");
}

TEST(ChildProcess, IsInAGroupOfItsOwn) {
  auto child = shell("test $(cut -d' ' -f5 /proc/$$/stat) = $$");
  EXPECT_EQ(child->bury(patience), "ended with status 0");
}

TEST(ChildProcess, NeedsAProgram) {
  const auto child = ChildProcess::spawn("/no/such/program", {});
  ASSERT_FALSE(child);
  EXPECT_EQ(child.error().kind, ErrorKind::settings);
  EXPECT_THAT(child.error().message,
              HasSubstr("/no/such/program does not start: No such file"));
}

TEST(ChildProcess, EndsWithItsOwner) {
  shell("kill -STOP $$").reset(); // or else this waits for it in vain
}

} // namespace
} // namespace parlour::adapters
