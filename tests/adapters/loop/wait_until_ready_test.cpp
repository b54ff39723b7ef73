#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "tests/adapters/loop/pipe.hpp"
#include "tests/support/no_descriptors.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using test::Pipe;
using Steady = std::chrono::steady_clock;

TEST(WaitUntilReady, SaysWhichDescriptorIsReady) {
  Pipe silent;
  Pipe loud;
  loud.say();
  pollfd awaited[] = {{silent.read_end(), POLLIN, 0},
                      {-1, POLLIN, 0},
                      {loud.read_end(), POLLIN, 0}};
  EXPECT_EQ(wait_until_ready(awaited), Waited::ready);
  EXPECT_EQ(awaited[0].revents, 0);
  EXPECT_EQ(awaited[1].revents, 0);
  EXPECT_EQ(awaited[2].revents, POLLIN);
}

TEST(WaitUntilReady, IsLateNotBeforeTheDeadline) {
  Pipe silent;
  pollfd awaited[] = {{silent.read_end(), POLLIN, 0}};
  const auto deadline = Steady::now() + 2ms;
  EXPECT_EQ(wait_until_ready(awaited, deadline), Waited::late);
  EXPECT_GE(Steady::now(), deadline);
  EXPECT_EQ(wait_until_ready(awaited, deadline - 1h), Waited::late);
}

TEST(WaitUntilReady, AHangUpIsReadyAndComesBeforeAPastDeadline) {
  Pipe closed;
  closed.close_write();
  pollfd awaited[] = {{closed.read_end(), POLLIN, 0}};
  EXPECT_EQ(wait_until_ready(awaited, Steady::now() - 1h), Waited::ready);
  EXPECT_EQ(awaited[0].revents, POLLHUP);
}

// A signal that does nothing but interrupt.
TEST(WaitUntilReady, GoesOnWaitingAfterASignal) {
  struct sigaction nothing {};
  nothing.sa_handler = [](int) {};
  struct sigaction before {};
  sigaction(SIGUSR1, &nothing, &before);
  Pipe pipe;
  const auto waiting = pthread_self();
  std::thread other([&] {
    for (int i = 0; i < 100; ++i)
      pthread_kill(waiting, SIGUSR1);
    pipe.say();
  });
  pollfd awaited[] = {{pipe.read_end(), POLLIN, 0}};
  EXPECT_EQ(wait_until_ready(awaited), Waited::ready);
  other.join();
  sigaction(SIGUSR1, &before, nullptr);
}

TEST(WaitUntilReady, SaysThatTheSystemCannotWait) {
  const test::NoDescriptors none;
  pollfd awaited[] = {{0, POLLIN, 0}};
  EXPECT_EQ(wait_until_ready(awaited), Waited::failed);
}

} // namespace
} // namespace parlour::adapters
