// ComponentProcess: a process and the conversation with it. One thread of its
// own starts it, reads what it says, and buries it.
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

struct ProcessOrder {
  std::filesystem::path program = "/proc/self/exe";
  std::vector<std::string> arguments; // such as "component", "GrammarNLU"
  // How long it has to come up, for each message, and to stop: hangs end so.
  Milliseconds start_within{30'000};
  Milliseconds answer_within{10'000};
  Milliseconds stop_within{1'000};
};

// One thread at a time calls; its destructor ends the process.
class ComponentProcess {
public:
  // Carries out what the process wants, one at a time: on the calling thread
  // while a call is under way, so that all of it is done when the call returns,
  // else on the thread of the process. An error ends the process.
  using Take = std::function<Expected<void>(const Frame&)>;
  // Called once, on any thread: the process is over, and nobody wanted that.
  using Over = std::function<void(const std::string& reason)>;

  // A line that it prints, on its thread.
  using Print = OutputLines::Print;

  ComponentProcess(const ProcessOrder& order, Take take, Print print);
  ComponentProcess(const ComponentProcess&) = delete;
  ComponentProcess& operator=(const ComponentProcess&) = delete;
  ~ComponentProcess();

  // The first that it says. An error where it does not come up.
  Expected<Frame> hello(Milliseconds within);
  // Its `done`. An error of kind Limit: the frame is too long, nothing
  // happened. Any other: the process is over; the message says why.
  Expected<Frame> call(const Frame& frame, Milliseconds within);
  // Without an answer; errors as FrameSocket::send has them.
  Expected<void> tell(const Frame& frame);

  // In place of the one before; called at once where it is over already.
  void when_over(Over over);

private:
  using Moment = FrameSocket::Moment;

  void work(const ProcessOrder& order);
  std::string read_all();
  void read_output();
  Expected<void> deliver(Frame frame);
  void finish(const std::string& reason);

  void begin_call();
  Expected<Frame> await(FrameKind kind, Moment deadline);
  Expected<Frame> next(Moment deadline);
  void end_call();
  void end(const std::string& reason);

  Take take_;
  OutputLines output_; // of the process's thread
  std::mutex mutex_;
  std::condition_variable changed_;
  std::unique_ptr<ChildProcess> child_; // none before it started
  std::deque<Frame> said_;              // for the caller
  bool calling_ = true;   // a call is under way: the first is hello
  bool settling_ = false; // what was said in it is still being carried out
  bool unwanted_ = false; // nobody listens any more
  std::string blame_;     // why we end it
  std::optional<std::string> over_; // why it is
  Over tell_over_;
  std::thread thread_; // the last: uses all of the above
};

} // namespace parlour::adapters
