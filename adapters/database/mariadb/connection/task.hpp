// Task is a coroutine that runs on one thread and is resumed by a polling loop.
// It lets a dialogue with a server be written in order, without blocking:
//
//  Task<int> twice() {
//    const int once = co_await ask();
//    co_return 2 * once;
//  }
#pragma once

#include <coroutine>
#include <exception>
#include <optional>
#include <utility>

namespace parlour::adapters {

// Starts when it is started or awaited. Destroying the object destroys the
// coroutine, also if it is suspended. Not thread-safe.
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
  // Whether the result is there. result() moves it out; call it once.
  bool done() const {
    return handle_.done();
  }
  T result() {
    return std::move(*handle_.promise().value);
  }

  // A task can be awaited by another one. The awaited task runs at once and
  // resumes the caller when it is done (symmetric transfer: the stack does not
  // grow).
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

  // The end of a coroutine: control passes to the caller, or back to whoever
  // started the outermost task, whose caller is the no-op coroutine.
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
    // Only a lack of memory throws here.
    std::terminate();
  }
};

} // namespace parlour::adapters
