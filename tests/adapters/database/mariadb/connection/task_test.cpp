#include <gtest/gtest.h>

#include "adapters/database/mariadb/connection/task.hpp"

namespace parlour::adapters {
namespace {

std::coroutine_handle<> put_down;

struct PutDown {
  bool await_ready() const noexcept {
    return false;
  }
  void await_suspend(std::coroutine_handle<> waiting) const {
    put_down = waiting;
  }
  void await_resume() const noexcept {}
};

struct Noted {
  explicit Noted(int& ended) : ended_(ended) {}
  ~Noted() {
    ++ended_;
  }
  int& ended_;
};

Task<int> inner(int& ended) {
  const Noted noted(ended);
  co_await PutDown{};
  co_return 20;
}

Task<int> outer(int& ended) {
  const int first = co_await inner(ended);
  const int second = co_await inner(ended);
  co_return first + second + 2;
}

TEST(Task, GoesOnWhereItWasPutDown) {
  int ended = 0;
  auto task = outer(ended);
  EXPECT_TRUE(task);
  task.start();
  EXPECT_FALSE(task.done());
  put_down.resume();
  EXPECT_EQ(ended, 1);
  EXPECT_FALSE(task.done());
  put_down.resume();
  ASSERT_TRUE(task.done());
  EXPECT_EQ(task.result(), 42);
}

TEST(Task, EndsInTheMiddleWithItsObject) {
  int ended = 0;
  {
    auto task = outer(ended);
    task.start();
    const auto moved = std::move(task);
    EXPECT_FALSE(task);
    EXPECT_EQ(ended, 0);
  }
  EXPECT_EQ(ended, 1);
  EXPECT_FALSE(Task<int>());
}

} // namespace
} // namespace parlour::adapters
