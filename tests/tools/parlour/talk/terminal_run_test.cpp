#include <clocale>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/eventfd.h>

#include "tests/support/no_descriptors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/terminal_fixture.hpp"
#include "tools/parlour/talk/terminal_run.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class ScreenTest : public testing::Test {
protected:
  ScreenTest() : interrupt_(eventfd(0, EFD_NONBLOCK)) {
    std::setlocale(LC_CTYPE, "C.UTF-8");
    in_ = std::fopen(terminal_.name().c_str(), "r");
    out_ = std::fopen(terminal_.name().c_str(), "w");
  }
  ~ScreenTest() override {
    std::fclose(in_);
    std::fclose(out_);
    close(interrupt_);
    std::setlocale(LC_CTYPE, "C");
  }
  Screen make(bool colour = false) {
    return Screen({in_, out_, interrupt_}, folder_.path() / "history", colour);
  }
  std::optional<std::string> read(Screen& screen, const std::string& keys) {
    std::jthread person([&] { terminal_.type_at_prompt(keys); });
    return screen.read_line();
  }
  void talk(ConversationDriver& driver, Screen& screen,
            const std::vector<std::string>& lines) {
    std::jthread person([&] {
      for (const auto& line : lines)
        terminal_.type_at_prompt(line);
    });
    talk_on_terminal(driver, screen);
  }

  test::TemporaryFolder folder_;
  test::PseudoTerminal terminal_{40};
  std::FILE* in_ = nullptr;
  std::FILE* out_ = nullptr;
  int interrupt_;
};

TEST_F(ScreenTest, reads_edited_lines) {
  auto screen = make();
  EXPECT_EQ(read(screen, "helo\blo\n"), "hello");
  EXPECT_EQ(read(screen, "\n"), "");
  EXPECT_EQ(read(screen, "Gr\xC3\xBC\xC3\x9F Gott\n"),
            "Gr\xC3\xBC\xC3\x9F Gott");
}

TEST_F(ScreenTest, shows_a_status_before_the_prompt) {
  const winsize wide{24, 100, 0, 0};
  ioctl(fileno(out_), TIOCSWINSZ, &wide);
  auto screen = make();
  screen.status("listening");
  std::jthread person([&] {
    EXPECT_THAT(terminal_.type_at_prompt("hel"), EndsWith("listening > "));
    terminal_.seen_until("hel");
    screen.status("speaking");
    terminal_.seen_until("speaking > hel");
    screen.status("");
    EXPECT_THAT(terminal_.seen_until("> hel"), Not(HasSubstr("ing > ")));
    terminal_.type("lo\n");
  });
  EXPECT_EQ(screen.read_line(), "hello");
}

// There would be no room for what is typed.
TEST_F(ScreenTest, shows_no_status_where_the_terminal_is_narrow) {
  auto screen = make();
  screen.status("listening");
  std::string seen;
  std::jthread person([&] { seen = terminal_.type_at_prompt("hello\n"); });
  EXPECT_EQ(screen.read_line(), "hello");
  person.join();
  EXPECT_THAT(seen, Not(HasSubstr("listening")));
}

TEST_F(ScreenTest, keeps_a_history) {
  {
    auto screen = make();
    for (const auto* line : {"first\n", "  \n", "second\n"})
      read(screen, line);
  }
  EXPECT_THAT(folder_.read("history"), HasSubstr("first"));
  auto screen = make();
  EXPECT_EQ(read(screen, "\x10\x10\n"), "first"); // up, up
}

TEST_F(ScreenTest, ends_at_the_end_of_input_and_when_interrupted) {
  auto screen = make();
  EXPECT_EQ(read(screen, "\x04"), std::nullopt);
  eventfd_write(interrupt_, 1);
  EXPECT_EQ(screen.read_line(), std::nullopt);
}

// The system cannot wait: to try again and again would take all of the
// processor.
TEST_F(ScreenTest, ends_when_nothing_can_be_waited_for) {
  auto screen = make();
  const test::NoDescriptors none;
  EXPECT_EQ(screen.read_line(), std::nullopt);
}

TEST_F(ScreenTest, ends_when_its_terminal_has_gone) {
  auto screen = make();
  terminal_.hang_up();
  EXPECT_EQ(screen.read_line(), std::nullopt);
}

TEST_F(ScreenTest, shows_the_robot_s_words_above_the_line_being_typed) {
  auto screen = make();
  std::jthread robot([&] {
    terminal_.type_at_prompt("half a line");
    terminal_.seen_until("half a line");
    screen.say("By the way.");
    const auto seen = terminal_.seen_until("> half a line");
    EXPECT_THAT(seen, HasSubstr("\r\033[JBy the way.\r\n"));
    terminal_.type(" and the rest\n");
  });
  EXPECT_EQ(screen.read_line(), "half a line and the rest");
}

TEST_F(ScreenTest, goes_up_over_a_line_that_is_longer_than_a_row) {
  auto screen = make();
  const std::string words(50, 'a');
  std::jthread robot([&] {
    terminal_.type_at_prompt(words + "b");
    terminal_.seen_until("b");
    screen.say("Yes.");
    EXPECT_THAT(terminal_.seen_until("Yes."), HasSubstr("\033[1A\r\033[JYes."));
    terminal_.type("\n");
  });
  EXPECT_EQ(screen.read_line(), words + "b");
}

TEST_F(ScreenTest, has_colours_only_where_they_are_wanted) {
  {
    auto screen = make(true);
    screen.say("words");
    screen.note("note");
    screen.flush();
  }
  EXPECT_THAT(terminal_.seen_until("note"),
              HasSubstr("\033[1mwords\033[0m\r\n\033[90mnote"));
  terminal_.seen_until("\n");
  auto screen = make(false);
  screen.say("words");
  screen.flush();
  EXPECT_THAT(terminal_.seen_until("words"), Not(HasSubstr("\033")));
}

class NotingDriver : public ConversationDriver {
public:
  explicit NotingDriver(bool is_virtual) : virtual_(is_virtual) {}
  void enter(const std::vector<std::string>& turns) override {
    calls.insert(calls.end(), turns.begin(), turns.end());
  }
  void run_until_quiet() override {
    calls.emplace_back("(quiet)");
  }
  void let_time_pass() override {
    calls.emplace_back("(step)");
  }
  bool is_virtual() const override {
    return virtual_;
  }
  std::vector<std::string> calls;

private:
  bool virtual_;
};

TEST_F(ScreenTest, makes_a_turn_of_each_line) {
  auto screen = make();
  NotingDriver real(false);
  talk(real, screen, {"one\n", "\n", "two\n", "\x04"});
  EXPECT_THAT(real.calls, ElementsAre("one", "two"));
}

TEST_F(ScreenTest, lets_virtual_time_go_on_at_an_empty_line) {
  auto screen = make();
  NotingDriver driver(true);
  talk(driver, screen, {"one\n", "\n", "\x04"});
  EXPECT_THAT(driver.calls, ElementsAre("one", "(quiet)", "(step)"));
}

} // namespace
} // namespace parlour::tools
