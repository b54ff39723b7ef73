#include <condition_variable>
#include <mutex>
#include <sstream>
#include <streambuf>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/console/printer.hpp"

namespace parlour::tools {
namespace {

// A reader that does not read until the test lets it.
class Stalled : public std::streambuf {
public:
  void go_on() {
    std::lock_guard lock(mutex_);
    reads_ = true;
    changed_.notify_all();
  }
  void wait_until_written_to() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return written_to_; });
  }

protected:
  int_type overflow(int_type character) override {
    wait();
    return character;
  }
  std::streamsize xsputn(const char*, std::streamsize size) override {
    wait();
    return size;
  }

private:
  void wait() {
    std::unique_lock lock(mutex_);
    written_to_ = true;
    changed_.notify_all();
    changed_.wait(lock, [&] { return reads_; });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool written_to_ = false;
  bool reads_ = false;
};

TEST(Printer, writes_lines_in_their_order) {
  std::ostringstream both;
  Printer printer(both, both, {});
  printer.out("one");
  printer.err("two");
  printer.out("three");
  EXPECT_TRUE(printer.finish());
  EXPECT_EQ(both.str(), "one\ntwo\nthree\n");
}

TEST(Printer, keeps_a_status_below_all_lines) {
  std::ostringstream both;
  Printer printer(both, both, {});
  printer.status("a");
  printer.out("one");
  printer.status("b");
  EXPECT_TRUE(printer.finish());
  printer.status("too late");
  // What was shown in between depends on the threads.
  const auto shown = both.str();
  EXPECT_TRUE(shown.ends_with("\n") || shown.ends_with("\r\033[K"));
  EXPECT_NE(shown.find("one\n"), std::string::npos);
  EXPECT_EQ(shown.find("aone"), std::string::npos);
  EXPECT_EQ(shown.find("bone"), std::string::npos);
  EXPECT_EQ(shown.find("too late"), std::string::npos);
}

TEST(Printer, tells_once_that_nobody_listens) {
  int closed = 0;
  std::stringbuf unwritable(std::ios::in);
  std::ostream nowhere(&unwritable);
  std::ostringstream err;
  Printer printer(nowhere, err, [&] { ++closed; });
  printer.out("one");
  printer.out("two");
  printer.err("three");
  EXPECT_TRUE(printer.finish());
  EXPECT_EQ(closed, 1);
  EXPECT_EQ(err.str(), "three\n");
}

// Adding lines never blocks; wait_for_room() does, but not for ever.
TEST(Printer, holds_nobody_up_where_the_reader_has_stopped) {
  static auto& stalled = *new Stalled; // used by the thread that is left
  static auto& out = *new std::ostream(&stalled);
  int closed = 0;
  Printer printer(out, out, [&] { ++closed; });
  printer.out(std::string(room_to_write, 'x'));
  stalled.wait_until_written_to();
  printer.out("more");
  EXPECT_EQ(closed, 0);
  printer.out(std::string(max_to_write, 'x')); // too much: the reader has gone
  EXPECT_EQ(closed, 1);
  printer.give_up();
  printer.wait_for_room();
  EXPECT_FALSE(printer.finish());
  stalled.go_on();
}

TEST(Printer, waits_for_a_slow_reader) {
  Stalled stalled;
  std::ostream out(&stalled);
  Printer printer(out, out, {});
  printer.out(std::string(room_to_write, 'x'));
  stalled.wait_until_written_to();
  stalled.go_on();
  printer.wait_for_room();
  EXPECT_TRUE(printer.finish());
}

} // namespace
} // namespace parlour::tools
