// The program on a terminal, from keys to exit status.
#include <csignal>

#include <sys/wait.h>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"
#include "tests/tools/parlour/terminal_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

class TerminalProgramTest : public CommandTest {
protected:
  ~TerminalProgramTest() override {
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
  }

  void start(std::vector<std::string> more = {}) {
    std::vector<std::string> words{test::program_path(), "run",
                                   application("parting"), "--data",
                                   folder_.path().string()};
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char*> arguments;
    for (auto& word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const auto device = terminal_.name();
    child_ = fork();
    if (child_ == 0)
      become(device, arguments.data());
  }
  // Only calls that are allowed between fork and exec.
  [[noreturn]] static void become(const std::string& device,
                                  char* const* arguments) {
    setsid();
    const auto terminal = open(device.c_str(), O_RDWR);
    ioctl(terminal, TIOCSCTTY, 0);
    for (const auto stream : {0, 1, 2})
      dup2(terminal, stream);
    signal(SIGINT, SIG_DFL);
    signal(SIGHUP, SIG_DFL);
    execv(arguments[0], arguments);
    _exit(127);
  }
  int status() {
    int status = 0;
    waitpid(std::exchange(child_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  test::TemporaryFolder folder_;
  test::PseudoTerminal terminal_;
  pid_t child_ = 0;
};

TEST_F(TerminalProgramTest, talks_until_the_end_of_input) {
  start();
  terminal_.seen_until("Hello.");
  terminal_.type_at_prompt("one\n");
  terminal_.seen_until("You said one.");
  terminal_.type_at_prompt("\x04");
  EXPECT_EQ(status(), exit_code::success);
  EXPECT_THAT(folder_.read("history"), HasSubstr("one"));
}

TEST_F(TerminalProgramTest, ends_its_sessions_at_ctrl_c) {
  start();
  terminal_.type_at_prompt("half a li\x03");
  const auto rest = terminal_.rest();
  EXPECT_EQ(status(), exit_code::interrupted);
  EXPECT_THAT(rest, HasSubstr("See you."));
  EXPECT_THAT(rest, Not(HasSubstr("still at work")));
}

TEST_F(TerminalProgramTest, ends_in_the_middle_at_ctrl_c) {
  start();
  for (const auto* line : {"later\n", "call\n", "one\n"})
    terminal_.type_at_prompt(line);
  terminal_.seen_until("You said one.");
  terminal_.type("\x03");
  const auto rest = terminal_.rest();
  EXPECT_EQ(status(), exit_code::interrupted);
  EXPECT_THAT(rest, HasSubstr("See you."));
  EXPECT_THAT(rest, Not(HasSubstr("still at work")));
}

TEST_F(TerminalProgramTest, ends_when_the_terminal_goes_away) {
  start();
  terminal_.seen_until("> ");
  terminal_.hang_up();
  // Either the end of the input or the signal is seen first; the signal may
  // even come when the program is about to exit.
  EXPECT_THAT(status(), testing::AnyOf(exit_code::success,
                                       exit_code::interrupted, -SIGHUP));
}

TEST_F(TerminalProgramTest, lets_virtual_time_go_on_at_an_empty_line) {
  start({"--clock", "2026-11-21 09:00"});
  terminal_.type_at_prompt("later\n");
  terminal_.type_at_prompt("\n");
  terminal_.seen_until("Now.");
  terminal_.type_at_prompt("\x04");
  EXPECT_EQ(status(), exit_code::success);
}

TEST_F(TerminalProgramTest, keeps_to_a_file_what_nobody_asked_to_see) {
  start({"--clock", "2026-11-21 09:00"});
  std::string seen;
  for (const auto* line : {"call\n", "\n", "\n", "\x04"})
    seen += terminal_.type_at_prompt(line);
  EXPECT_THAT(seen + terminal_.rest(), Not(HasSubstr("Telephone")));
  EXPECT_EQ(status(), exit_code::success);
  EXPECT_THAT(folder_.read("log"), HasSubstr("LogTelephone."));
}

TEST_F(TerminalProgramTest, shows_what_happens_without_colour_where_none_is) {
  setenv("NO_COLOR", "1", 1);
  start({"--trace"});
  auto seen = terminal_.seen_until("Hello.");
  terminal_.type_at_prompt("one\n");
  seen += terminal_.seen_until("You said one.\r\n");
  terminal_.type_at_prompt("\x04");
  EXPECT_EQ(status(), exit_code::success);
  unsetenv("NO_COLOR");
  EXPECT_THAT(seen, HasSubstr("transition  "));
  EXPECT_THAT(seen, HasSubstr("message     "));
  EXPECT_THAT(seen, Not(HasSubstr("\033[90m")));
}

} // namespace
} // namespace parlour::tools
