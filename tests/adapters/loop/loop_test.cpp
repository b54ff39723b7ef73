#include <csignal>
#include <future>
#include <stdexcept>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/loop/loop.hpp"
#include "tests/support/no_descriptors.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

class LoopTest : public testing::Test {
protected:
  std::vector<std::string> thrown;
  std::unique_ptr<Loop> loop = Loop::start([this](const std::string& what) {
                                 thrown.push_back(what);
                               }).value();
};

TEST_F(LoopTest, DoesOneThingAfterTheOtherAndAllBeforeItStops) {
  std::vector<int> done;
  std::promise<void> third;
  loop->post([&] {
    loop->post([&] { done.push_back(2); });
    loop->post([&] {
      done.push_back(3);
      third.set_value();
    });
    done.push_back(1);
  });
  third.get_future().wait();
  loop->post([&] { done.push_back(4); });
  loop->stop();
  EXPECT_THAT(done, ElementsAre(1, 2, 3, 4));
}

TEST_F(LoopTest, DoesNothingOnceItHasStopped) {
  loop->stop();
  loop->post([] { FAIL(); });
  loop->stop();
}

TEST_F(LoopTest, TakesWhatManyThreadsPost) {
  int count = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int j = 0; j < 1'000; ++j)
        loop->post([&] { ++count; });
    });
  for (auto& thread : threads)
    thread.join();
  loop->stop();
  EXPECT_EQ(count, 4'000);
}

TEST_F(LoopTest, ItsThreadTakesNoSignals) {
  std::promise<bool> blocked;
  loop->post([&] {
    sigset_t mask;
    pthread_sigmask(SIG_BLOCK, nullptr, &mask);
    blocked.set_value(sigismember(&mask, SIGTERM) &&
                      sigismember(&mask, SIGINT));
  });
  EXPECT_TRUE(blocked.get_future().get());
  sigset_t mine;
  pthread_sigmask(SIG_BLOCK, nullptr, &mine);
  EXPECT_FALSE(sigismember(&mine, SIGTERM));
}

TEST_F(LoopTest, GoesOnAfterAnException) {
  for (const auto* what : {"one", "two"})
    loop->post([what] { throw std::runtime_error(what); });
  loop->post([] { throw 3; });
  loop->stop();
  EXPECT_THAT(thrown,
              ElementsAre("one", "two", "an exception of an unknown type"));
}

TEST_F(LoopTest, LingersWhileSomethingIsWaitedFor) {
  asio::steady_timer soon(loop->context(), 1ms);
  asio::steady_timer much_later(loop->context(), 1h);
  bool rang = false;
  soon.async_wait([&](asio::error_code) {
    rang = true;
    much_later.cancel();
  });
  much_later.async_wait([](asio::error_code) {});
  loop->stop(1h);
  EXPECT_TRUE(rang);
}

TEST(Loop, SaysThatThereAreNoDescriptors) {
  const auto loop = [] {
    const test::NoDescriptors none;
    return Loop::start([](const std::string&) {});
  }();
  ASSERT_FALSE(loop);
  EXPECT_EQ(loop.error().kind, ErrorKind::limit);
  EXPECT_EQ(loop.error().message, "Too many open files");
}

} // namespace
} // namespace parlour::adapters
