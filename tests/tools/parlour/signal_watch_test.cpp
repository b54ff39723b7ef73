#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tools/parlour/descriptor_source.hpp"
#include "tools/parlour/signal_watch.hpp"

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

// Whatever hangs in the first one's action.
TEST(SignalWatchDeathTest, ends_at_once_at_the_second_signal) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
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

TEST(SignalWatch, leaves_a_hang_up_alone_that_was_to_be_ignored) {
  const auto before = signal(SIGHUP, SIG_IGN);
  {
    SignalWatch watch;
    sigset_t blocked;
    pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    EXPECT_EQ(sigismember(&blocked, SIGINT), 1);
    EXPECT_EQ(sigismember(&blocked, SIGHUP), 0);
  }
  signal(SIGHUP, SIG_DFL);
  {
    SignalWatch watch;
    sigset_t blocked;
    pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    EXPECT_EQ(sigismember(&blocked, SIGHUP), 1);
  }
  signal(SIGHUP, before);
}

TEST(SignalWatch, takes_a_closed_output_for_no_interruption) {
  SignalWatch watch;
  watch.raise_closed();
  EXPECT_TRUE(watch.closed());
  EXPECT_FALSE(watch.interrupted());
}

} // namespace
} // namespace parlour::tools
