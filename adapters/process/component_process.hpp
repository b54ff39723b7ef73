// ComponentProcess runs a component's process and the conversation with it. A
// thread of its own starts the process, reads its messages and reaps it.
//
// The caller makes calls (start a component, handle a message …) and waits for
// the `done` of each. What the process wants meanwhile (fire an event, log a
// line …) is given to `take`, in the order in which it was said:
//
//  during a call       queued, and taken by the calling thread
//  between two calls   taken by the process's thread
//
// So everything that a call leads to has happened when the call returns, which
// virtual time depends on. A process that does not answer in time is killed.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "adapters/process/child_process.hpp"
#include "adapters/process/output_lines.hpp"

namespace parlour::adapters {

// How to start a process, and how long it may take.
struct ProcessOrder {
  std::filesystem::path program = "/proc/self/exe";
  // Such as "component", "GrammarNLU".
  std::vector<std::string> arguments;
  // The time to start, for each message, and to stop.
  Milliseconds start_within{30'000};
  Milliseconds answer_within{10'000};
  Milliseconds stop_within{1'000};
};

// One thread at a time may call hello, call and when_over; tell may be called
// by `take` as well. The destructor ends the process.
class ComponentProcess {
public:
  // Carries out a message of the process, which it may tell something
  // meanwhile. The destructor waits for it, so the reference stays valid while
  // the owner already forgets its pointer. An error ends the process.
  using Take =
      std::function<Expected<void>(ComponentProcess&, const IpcMessage&)>;
  // Called once, on any thread, when the process ends although nobody asked for
  // it.
  using Over = std::function<void(const std::string& reason)>;

  // Receives each line that the process prints, on the process's thread.
  using Print = OutputLines::Print;

  ComponentProcess(const ProcessOrder& order, Take take, Print print);
  ComponentProcess(const ComponentProcess&) = delete;
  ComponentProcess& operator=(const ComponentProcess&) = delete;
  ~ComponentProcess();

  // Waits for the first message of the process, `hello` or `refuse`. Call it
  // once, before anything else. The error says why the process did not start.
  Expected<IpcMessage> hello(Milliseconds within);
  // Sends a message and waits for the process's `done`. An error of kind Limit
  // means that the message is too long and was not sent. Any other error means
  // that the process has ended; its message says why.
  Expected<IpcMessage> call(const IpcMessage& message, Milliseconds within);
  // Sends a message that has no answer. Errors as in IpcSocket::send.
  Expected<void> tell(const IpcMessage& message);

  // Replaces the previous function. It is called at once if the process has
  // ended already; an empty one is never called.
  void when_over(Over over);

private:
  using Moment = IpcSocket::Moment;

  void work(const ProcessOrder& order);
  std::string read_all();
  void read_output();
  Expected<void> deliver(IpcMessage message);
  void finish(const std::string& reason);

  void begin_call();
  Expected<IpcMessage> await(IpcKind kind, Moment deadline);
  Expected<IpcMessage> next(Moment deadline);
  void end_call();
  void end(const std::string& reason);

  Take take_;
  // Used by the process's thread only.
  OutputLines output_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Null until the process has been started.
  std::unique_ptr<ChildProcess> child_;
  // Messages that wait for the calling thread.
  std::deque<IpcMessage> said_;
  // A call is under way. It begins as true: the first call is hello().
  bool calling_ = true;
  // The call has returned, but its last messages are still being taken.
  bool settling_ = false;
  // The destructor has begun; nothing is taken any more.
  bool unwanted_ = false;
  // Why we ended the process; empty if we did not.
  std::string blame_;
  // Why the process has ended; empty while it runs.
  std::optional<std::string> over_;
  Over tell_over_;
  // The last member: the thread uses all others.
  std::thread thread_;
};

} // namespace parlour::adapters
