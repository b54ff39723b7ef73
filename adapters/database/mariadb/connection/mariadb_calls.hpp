// MariaDBCalls makes calls of the C library's non-blocking interface: each
// blocking function f is there a pair, f_start, which begins it, and f_cont,
// which continues it. A call is awaited by a coroutine (task.hpp), which is
// suspended while the server has not answered, and resumed by whoever polls the
// socket:
//
//  const auto failed = co_await calls.make<int>(
//      mysql_real_query_start, mysql_real_query_cont, handle, sql, size);
//
// Not thread-safe; one call at a time.
#pragma once

#include <chrono>
#include <coroutine>

#include "runtime/base/clock.hpp"

namespace parlour::adapters {

class MariaDBCalls {
public:
  using Moment = std::chrono::steady_clock::time_point;

  MariaDBCalls() = default;
  MariaDBCalls(const MariaDBCalls&) = delete;
  MariaDBCalls& operator=(const MariaDBCalls&) = delete;

  // Begins a call. One that is done at once never suspends the coroutine.
  template <class Result, class Start, class Continue, class Handle,
            class... Arguments>
  auto make(Start start, Continue proceed, Handle* handle,
            Arguments... arguments) {
    return Call<Result, Continue, Handle>(*this, start, proceed, handle,
                                          arguments...);
  }

  // Sets the deadline of the current call and those that follow.
  void give_time(Milliseconds time);
  // Whether it has passed.
  bool is_late() const;

  // The interface for whoever polls.
  bool is_waiting() const {
    return static_cast<bool>(waiting_);
  }
  // The poll events to wait for: POLLIN, POLLOUT.
  short interest() const;
  // Moment::max() if nothing waits.
  Moment deadline() const;
  // Continues the call, and resumes the coroutine once it is done. `ready` is
  // what poll returned in revents, or 0 if the deadline has passed: then the
  // call ends with an error.
  void go_on(short ready);

private:
  // A call that has begun and waits for the server.
  class Pending {
  public:
    // Continues the call. Returns the flags it waits for next (MYSQL_WAIT_READ
    // …), or 0 if it is done.
    virtual int proceed(int ready) = 0;

  protected:
    ~Pending() = default;
  };
  template <class Result, class Continue, class Handle>
  class Call;

  Moment deadline_ = Moment::max();
  // What the suspended coroutine waits for, where to resume it, and the flags
  // that the library wants to see.
  Pending* pending_ = nullptr;
  std::coroutine_handle<> waiting_;
  int wanted_ = 0;
};

// Awaitable. The constructor starts the call.
template <class Result, class Continue, class Handle>
class MariaDBCalls::Call final : Pending {
public:
  template <class Start, class... Arguments>
  Call(MariaDBCalls& calls, Start start, Continue next, Handle* handle,
       Arguments... arguments)
      : calls_(calls), proceed_(next), handle_(handle),
        wanted_(start(&result_, handle, arguments...)) {}
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  bool await_ready() const noexcept {
    return wanted_ == 0;
  }
  void await_suspend(std::coroutine_handle<> waiting) {
    calls_.pending_ = this;
    calls_.waiting_ = waiting;
    calls_.wanted_ = wanted_;
  }
  Result await_resume() const {
    return result_;
  }

private:
  int proceed(int ready) override {
    return proceed_(&result_, handle_, ready);
  }

  MariaDBCalls& calls_;
  Continue proceed_;
  Handle* handle_;
  Result result_{};
  int wanted_;
};

} // namespace parlour::adapters
