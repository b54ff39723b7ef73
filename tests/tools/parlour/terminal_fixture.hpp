// PseudoTerminal: a terminal on which the test types and reads.
#pragma once

#include <string>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sched.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace parlour::test {

class PseudoTerminal {
public:
  // After this time without output the test gives up. A test that passes never
  // waits so long.
  static constexpr int patience = 60'000; // ms

  explicit PseudoTerminal(unsigned short columns = 80)
      : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (grantpt(master_) != 0 || unlockpt(master_) != 0)
      ADD_FAILURE() << "there is no pseudo terminal";
    const winsize size{24, columns, 0, 0};
    ioctl(master_, TIOCSWINSZ, &size);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal() {
    hang_up();
  }

  // The device that the program opens.
  std::string name() const {
    return ptsname(master_);
  }
  void type(const std::string& keys) const {
    EXPECT_EQ(write(master_, keys.data(), keys.size()),
              static_cast<ssize_t>(keys.size()));
  }
  // Types after the editor has taken over the terminal, because before that the
  // terminal itself interprets some keys. Returns what was shown before.
  std::string type_at_prompt(const std::string& keys) {
    auto seen = seen_until("> ");
    termios mode{};
    while (tcgetattr(master_, &mode) == 0 && (mode.c_lflag & ICANON) != 0)
      sched_yield();
    type(keys);
    return seen;
  }
  // Reads until `text` is shown; returns what was shown since the last call.
  std::string seen_until(const std::string& text) {
    auto found = shown_.find(text);
    while (found == std::string::npos && read_more())
      found = shown_.find(text);
    if (found == std::string::npos)
      ADD_FAILURE() << "'" << text << "' was not shown, but: " << shown_;
    const auto end =
        found == std::string::npos ? shown_.size() : found + text.size();
    auto seen = shown_.substr(0, end);
    shown_.erase(0, end);
    return seen;
  }
  // Reads until nobody has the other side open any more.
  std::string rest() {
    while (read_more()) {
    }
    return std::exchange(shown_, {});
  }
  void hang_up() {
    if (master_ >= 0)
      close(std::exchange(master_, -1));
  }

private:
  bool read_more() {
    pollfd waiting{master_, POLLIN, 0};
    if (poll(&waiting, 1, patience) <= 0)
      return false;
    char buffer[4096];
    const auto size = ::read(master_, buffer, sizeof buffer);
    if (size > 0)
      shown_.append(buffer, static_cast<std::size_t>(size));
    return size > 0;
  }

  int master_;
  std::string shown_;
};

} // namespace parlour::test
