// MoonshineProgram: the recogniser's program while it runs. A loop of its own
// writes to it, reads from it and waits for what it owes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "adapters/asr/moonshine_frames.hpp"
#include "adapters/loop/alarm.hpp"
#include "adapters/loop/loop.hpp"
#include "adapters/loop/watch.hpp"
#include "adapters/process/output_lines.hpp"
#include "adapters/process/started_process.hpp"

namespace parlour::adapters::moonshine {

// How to start the program, and how long it may take.
// `ready_within` counts from the start, `answer_within` from the question, or
// from when the program was ready.
struct ProgramOrder {
  std::filesystem::path program; // absolute
  std::vector<std::string> arguments;
  Milliseconds ready_within{60'000};
  Milliseconds answer_within{10'000};
  // In bytes. While it loads, the application's domain model waits: seven
  // megabytes for the receptionist, and again whenever a column has new values.
  std::size_t most_unsent = 64 << 20;
};

// All are called on the loop's thread, and not during or after the destructor.
struct ProgramCalls {
  // A partial result, a result or a rejection.
  std::function<void(Answer)> answered;
  // The program is ready, after so much time.
  std::function<void(Milliseconds)> ready;
  // The program has ended, or was ended because of this: called once, at last.
  std::function<void(const std::string& reason)> over;
  // A line that it prints on standard error.
  std::function<void(const std::string& line)> print;
};

// The program has three debts, each with its own time: to be ready, to answer
// what was asked, and to read. It is ended when it owes one too long, and then
// over() is called.
class MoonshineProgram {
public:
  // Starts the program; what is sent waits until it is ready.
  static Expected<std::unique_ptr<MoonshineProgram>>
  start(const ProgramOrder& order, ProgramCalls calls);
  MoonshineProgram(const MoonshineProgram&) = delete;
  MoonshineProgram& operator=(const MoonshineProgram&) = delete;
  // Ends the program by force.
  ~MoonshineProgram();

  // Thread-safe; never blocks. The program is ended if it does not read.
  void send(std::string frame);
  // The same for what must be answered in time once the program is ready: the
  // end of a turn, or a piece of a stream.
  void ask(TurnNumber turn, std::string frame);

private:
  class Connection;
  using Moment = Loop::Moment;

  MoonshineProgram(const ProgramOrder& order, ProgramCalls calls,
                   std::unique_ptr<Loop> loop,
                   std::unique_ptr<Connection> connection);

  // On the loop's thread.
  void listen();
  void read();
  void read_errors();
  void take(std::string_view bytes);
  void take(Answer answer);
  void write();
  void become_ready();
  // What the program owes next, and what it did wrong if it is late.
  std::pair<Moment, const char*> next_debt() const;
  void look_at_clock();
  void end(const std::string& reason);

  const ProgramOrder order_;
  const ProgramCalls calls_;
  const std::unique_ptr<Loop> loop_;

  // Used on the loop's thread.
  std::unique_ptr<Connection> connection_; // null: it is over
  AnswerReader answers_;
  OutputLines errors_;
  std::string unsent_;
  bool is_ready_ = false;
  const Moment started_;
  // What ask() was called for and is not answered.
  std::map<TurnNumber, Moment> awaited_; // since when
  Watch input_;
  Watch output_;
  Watch error_output_;
  Alarm alarm_;
};

} // namespace parlour::adapters::moonshine
