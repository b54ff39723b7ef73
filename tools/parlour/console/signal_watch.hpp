// SignalWatch: handles Ctrl-C, SIGTERM and SIGHUP on a thread of its own, so
// that the reaction may call anything (a signal handler may not).
//
// SIGINT, SIGTERM and SIGHUP, unless ignored (nohup), are blocked in the thread
// that makes the watch and in all threads it starts later, and read through a
// signalfd. After the first signal, SIGINT and SIGTERM are left to
// what they did before: a second Ctrl-C ends the process, whatever hangs.
// SIGPIPE is ignored, so that a closed output shows as a failed write.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include <signal.h>

namespace parlour::tools {

class SignalWatch {
public:
  // Make it before any other thread: a thread started earlier would not have
  // the signals blocked. Throws std::system_error if there are no descriptors.
  SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  // Restores the signal mask of the calling thread.
  ~SignalWatch();

  // `action` runs on the watching thread when a signal comes, and at once on
  // the calling thread if one has come already. It may run more than once, so
  // it has to be idempotent, and it must not call on_interrupt(). Null removes
  // the action: when the call returns, it is not running and will not run
  // again.
  void on_interrupt(std::function<void()> action);

  // Like a signal, but from the program itself: the output was closed. The exit
  // status is not affected. From any thread.
  void raise_closed();

  bool interrupted() const {
    return signal_ != 0;
  }
  // The exit status of a program that ended in order after a signal:
  // interrupted for SIGINT, otherwise success.
  int status() const;
  bool closed() const {
    return closed_;
  }
  // Becomes readable at the first signal and stays so: for poll().
  int descriptor() const {
    return wake_;
  }

private:
  // The watching thread.
  void watch();
  void take_signal();
  void act();

  sigset_t before_{}; // the signal mask to restore
  int signals_ = -1;  // the signalfd
  int wake_ = -1;     // an eventfd that is never read
  // An eventfd that ends the watching thread.
  int stop_ = -1;
  std::atomic<int> signal_ = 0; // the last one received; 0: none
  std::atomic<bool> closed_ = false;
  std::mutex mutex_;
  std::function<void()> action_; // guarded by mutex_
  std::thread thread_;
};

} // namespace parlour::tools
