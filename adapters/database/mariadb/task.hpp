// Task: what goes on at a connection, written in order though it never waits:
// it is put down where the other side has nothing to say yet, and taken up by
// whoever polls.
#pragma once

#include <coroutine>
#include <exception>
#include <optional>
#include <utility>

namespace parlour::adapters {

// Begins when it is awaited or started; ends, in the middle too, with the
// object. For one thread at a time.
template <class T>
class [[nodiscard]] Task {
public:
  struct promise_type;
  using Handle = std::coroutine_handle<promise_type>;

  Task() = default;
  explicit Task(Handle handle) : handle_(handle) {}
  Task(Task&& other) noexcept : handle_(std::exchange(other.handle_, {})) {}
  Task& operator=(Task&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Task() {
    if (handle_)
      handle_.destroy();
  }

  explicit operator bool() const {
    return static_cast<bool>(handle_);
  }
  void start() {
    handle_.resume();
  }
  bool done() const {
    return handle_.done();
  }
  T result() {
    return std::move(*handle_.promise().value);
  }

  // Awaited by another task, which goes on when this one is done.
  bool await_ready() const noexcept {
    return false;
  }
  std::coroutine_handle<> await_suspend(std::coroutine_handle<> caller) {
    handle_.promise().caller = caller;
    return handle_;
  }
  T await_resume() {
    return result();
  }

private:
  Handle handle_;
};

template <class T>
struct Task<T>::promise_type {
  std::optional<T> value;
  std::coroutine_handle<> caller = std::noop_coroutine();

  struct GoOnWithCaller {
    bool await_ready() noexcept {
      return false;
    }
    std::coroutine_handle<> await_suspend(Handle done) noexcept {
      return done.promise().caller;
    }
    void await_resume() noexcept {}
  };

  Task get_return_object() {
    return Task(Handle::from_promise(*this));
  }
  std::suspend_always initial_suspend() noexcept {
    return {};
  }
  GoOnWithCaller final_suspend() noexcept {
    return {};
  }
  void return_value(T result) {
    value.emplace(std::move(result));
  }
  [[noreturn]] void unhandled_exception() {
    std::terminate(); // out of memory; nothing else throws here
  }
};

} // namespace parlour::adapters
