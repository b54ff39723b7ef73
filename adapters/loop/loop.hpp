// Loop is a thread that waits for descriptors (Watch), for moments (Alarm) and
// for what other threads post, and does one thing after the other:
//
//  auto loop = Loop::start([](const std::string& what) { … });
//  Watch watch(**loop, [&](short ready) { … });
//  (*loop)->post([&] { watch.await(socket, POLLIN); });
//
// A watch or an alarm is used on the loop's thread only. It may be destroyed
// there, or anywhere once stop() has returned, but before the loop.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace asio {
class io_context;
}

namespace parlour::adapters {

struct StandaloneAsio;
template <class Asio>
class LoopOver;

class Loop {
public:
  using Moment = std::chrono::steady_clock::time_point;
  // It must not block for long. What it throws is given to the function that
  // start() got.
  using Action = std::function<void()>;
  // Gets what() of an exception, on the loop's thread. It must not throw.
  using Thrown = std::function<void(const std::string& what)>;

  // Starts the thread, on which all signals are blocked: other threads handle
  // them. The function gets the exceptions of actions, watches, alarms and of
  // asio's handlers, and the loop goes on: what an adapter throws is no reason
  // for others to end. The error, of kind Limit, says that the system has no
  // descriptors or threads left.
  static Expected<std::unique_ptr<Loop>> start(Thrown thrown);
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;
  // Stops the loop if nobody has.
  ~Loop();

  // Has the action done on the loop's thread, after those that were posted
  // before. Thread-safe; never blocks. After stop() it is never done.
  void post(Action action);

  // Ends the thread after what has been posted so far. It goes on for `linger`
  // at most, and only while something is being waited for. Call it from one
  // other thread; a second call does nothing.
  void stop(Milliseconds linger = Milliseconds::zero());

  // For transports that are written with asio. Its handlers run on the loop's
  // thread.
  asio::io_context& context();

private:
  using Thread = LoopOver<StandaloneAsio>;
  explicit Loop(std::unique_ptr<Thread> thread);

  const std::unique_ptr<Thread> thread_;
};

} // namespace parlour::adapters
