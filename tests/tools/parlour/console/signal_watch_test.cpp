#include <future>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tools/parlour/console/descriptor_source.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/signal_watch.hpp"

namespace parlour::tools {
namespace {

TEST(SignalWatch, calls_at_the_first_signal_and_wakes_a_reader) {
  SignalWatch watch;
  std::promise<void> called;
  std::atomic<bool> once = false;
  watch.on_interrupt([&] {
    if (!once.exchange(true))
      called.set_value();
  });
  EXPECT_FALSE(watch.interrupted());
  kill(getpid(), SIGINT);
  called.get_future().wait();
  EXPECT_TRUE(watch.interrupted());
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  DescriptorSource source(ends[0], watch.descriptor());
  EXPECT_EQ(source.read(std::nullopt).kind, Read::Kind::interrupted);
  close(ends[0]);
  close(ends[1]);
}

// Even if the first signal's action hangs.
TEST(SignalWatchDeathTest, ends_at_once_at_the_second_signal) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        // Who starts tests in the background ignores the first.
        signal(SIGINT, SIG_DFL);
        signal(SIGTERM, SIG_DFL);
        SignalWatch watch;
        std::promise<void> called;
        std::promise<void> never;
        watch.on_interrupt([&] {
          called.set_value();
          never.get_future().wait();
        });
        kill(getpid(), SIGINT);
        called.get_future().wait();
        kill(getpid(), SIGTERM);
        never.get_future().wait();
      },
      testing::KilledBySignal(SIGTERM), "");
}

// Which of the three signals a watch handles.
std::string taken() {
  SignalWatch watch;
  sigset_t blocked;
  pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  std::string all;
  for (const auto& [number, name] :
       {std::pair(SIGINT, "INT "), std::pair(SIGTERM, "TERM "),
        std::pair(SIGHUP, "HUP ")})
    if (sigismember(&blocked, number))
      all += name;
  return all;
}

TEST(SignalWatch, leaves_alone_what_was_to_be_ignored) {
  EXPECT_EQ(taken(), "INT TERM HUP ");
  for (const auto& [number, others] :
       {std::pair(SIGINT, "TERM HUP "), std::pair(SIGTERM, "INT HUP "),
        std::pair(SIGHUP, "INT TERM ")}) {
    const auto before = signal(number, SIG_IGN);
    EXPECT_EQ(taken(), others);
    signal(number, before);
  }
}

TEST(SignalWatch, says_how_an_end_in_order_counts) {
  for (const auto& [number, status] :
       {std::pair(SIGINT, exit_code::interrupted),
        std::pair(SIGTERM, exit_code::success),
        std::pair(SIGHUP, exit_code::success)}) {
    SignalWatch watch;
    EXPECT_EQ(watch.status(), exit_code::success);
    std::promise<void> called;
    std::atomic<bool> once = false;
    watch.on_interrupt([&] {
      if (!once.exchange(true))
        called.set_value();
    });
    kill(getpid(), number);
    called.get_future().wait();
    EXPECT_EQ(watch.status(), status) << number;
  }
}

TEST(SignalWatch, takes_a_closed_output_for_no_interruption) {
  SignalWatch watch;
  watch.raise_closed();
  EXPECT_TRUE(watch.closed());
  EXPECT_FALSE(watch.interrupted());
}

} // namespace
} // namespace parlour::tools
