// SignalWatch: Ctrl-C and requests to terminate as a call on a thread of its
// own, so that what happens then may be anything; and a descriptor that a
// waiting reader can poll. Until the first of them came, the signals SIGINT,
// SIGTERM and SIGHUP (those that are not ignored) are blocked in the thread
// that made it and in those it starts; a second SIGINT or SIGTERM does what it
// would do without a watch, whatever hangs then. SIGPIPE is ignored: a closed
// output shows as a failed write.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include <signal.h>

namespace parlour::tools {

class SignalWatch {
public:
  // Make it before any other thread. Throws std::system_error where the system
  // gives no descriptor.
  SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch();

  // `action` runs on the watching thread at the first signal, at once if it
  // came already. Null: nothing is called any more.
  void on_interrupt(std::function<void()> action);

  // Like a signal, from the program itself: the output was closed.
  void raise_closed();

  bool interrupted() const {
    return signal_ != 0;
  }
  // What a program returns that has ended in order since: as exit_code says.
  int status() const;
  bool closed() const {
    return closed_;
  }
  // Readable from the first signal on.
  int descriptor() const {
    return wake_;
  }

private:
  void watch();
  void take_signal();
  void act();

  sigset_t before_{};
  int signals_ = -1;
  int wake_ = -1; // an eventfd that is never read
  int stop_ = -1;
  std::atomic<int> signal_ = 0; // the first one
  std::atomic<bool> closed_ = false;
  std::mutex mutex_;
  std::function<void()> action_;
  std::thread thread_;
};

} // namespace parlour::tools
