#include <array>

#include <gmock/gmock.h>
#include <unistd.h>

#include "adapters/process/started_process.hpp"

namespace parlour::adapters {
namespace {

constexpr Milliseconds patience{60'000};

TEST(StartedProcess, HasTheDescriptorsItIsGiven) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const std::array given = {-1, pipe[1], pipe[1]};
  const auto process =
      StartedProcess::start("/bin/sh",
                            {"-c", "test \"$(readlink /proc/$$/fd/0)\" = "
                                   "/dev/null && test ! -e /proc/$$/fd/3 && "
                                   "echo one && echo two >&2"},
                            given)
          .value();
  EXPECT_EQ(process->bury(patience), "ended with status 0");
  std::array<char, 16> text{};
  EXPECT_EQ(::read(pipe[0], text.data(), text.size()), 8);
  EXPECT_STREQ(text.data(), "one\ntwo\n");
  for (const auto end : pipe)
    ::close(end);
}

TEST(StartedProcess, EndsWithItsOwner) {
  StartedProcess::start("/bin/sh", {"-c", "kill -STOP $$"}, {})
      .value()
      .reset(); // or else this waits for it in vain
}

TEST(StartedProcess, NeedsAProgram) {
  const auto process = StartedProcess::start("/no/such/program", {}, {});
  ASSERT_FALSE(process);
  EXPECT_EQ(process.error().kind, ErrorKind::settings);
}

} // namespace
} // namespace parlour::adapters
