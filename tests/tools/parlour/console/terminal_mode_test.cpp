#include <gtest/gtest.h>
#include <signal.h>

#include "tests/tools/parlour/terminal_fixture.hpp"
#include "tools/parlour/console/terminal_mode.hpp"

namespace parlour::tools {
namespace {

class TerminalModeDeathTest : public testing::Test {
protected:
  TerminalModeDeathTest() {
    GTEST_FLAG_SET(death_test_style, "fast"); // the same terminal
  }
  ~TerminalModeDeathTest() override {
    close(descriptor);
  }
  termios mode() const {
    termios found{};
    EXPECT_EQ(tcgetattr(descriptor, &found), 0);
    return found;
  }
  void hide_what_is_typed() const {
    auto changed = mode();
    changed.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(descriptor, TCSANOW, &changed);
  }
  bool shows_what_is_typed() const {
    return (mode().c_lflag & ECHO) != 0;
  }

  test::PseudoTerminal terminal;
  const int descriptor =
      open(terminal.name().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
};

TEST_F(TerminalModeDeathTest, PutsItBackAtTheEnd) {
  EXPECT_EXIT(
      {
        keep_terminal_mode(descriptor);
        hide_what_is_typed();
        end_now(3);
      },
      testing::ExitedWithCode(3), "");
  EXPECT_TRUE(shows_what_is_typed());
}

TEST_F(TerminalModeDeathTest, PutsItBackWhenASignalEndsTheProcess) {
  for (const int number : {SIGINT, SIGTERM}) {
    EXPECT_EXIT(
        {
          signal(number, SIG_DFL);
          keep_terminal_mode(descriptor);
          hide_what_is_typed();
          raise(number);
        },
        testing::KilledBySignal(number), "");
    EXPECT_TRUE(shows_what_is_typed());
  }
}

TEST_F(TerminalModeDeathTest, LeavesATerminalAloneThatItWasNotGiven) {
  EXPECT_EXIT(
      {
        hide_what_is_typed();
        end_now(0);
      },
      testing::ExitedWithCode(0), "");
  EXPECT_FALSE(shows_what_is_typed());
}

} // namespace
} // namespace parlour::tools
