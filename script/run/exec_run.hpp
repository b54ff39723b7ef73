// ExecRun: `parlour exec`, which runs a script without a conversation (language
// rules 1.2 and 9.7). Prints and logs go to given functions, files are read and
// written at once, and timers and waits happen in the order of their times.
// Every other effect is an error of kind Refused.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/outside/files.hpp"
#include "runtime/base/random.hpp"
#include "script/program/computing_host.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour {
class ByteReader;
class ByteWriter;
} // namespace parlour

namespace parlour::script {

// The surroundings of a run. The functions are called in the thread of the run.
struct ExecOptions {
  std::function<void(std::string_view)> print;
  std::function<void(std::string_view)> log;
  std::function<Timestamp()> now;
  // Returns at this time or later. Tests move a clock of their own instead of
  // waiting.
  std::function<void(Timestamp)> wait_until;
  // Null: there are no files, and statements that use them are refused.
  FileAccess files = {};
  std::uint64_t seed = 1;
  std::uint64_t instructions = defaults::exec_instructions; // of one event
};

// The error that ended a run.
struct ExecFailure {
  Error error;
  std::vector<std::string> stack; // innermost first
};

// A script's `main` and everything that it starts, run in steps. Between two
// steps a run can be written to bytes and continue in another process (language
// rule 10.4). Used by one thread. An example:
//
//   ExecRun run(program, options);
//   while (run.step())
//     continue;
//   if (run.failure())
//     report(*run.failure());
class ExecRun : private LonelyHost {
public:
  ExecRun(std::shared_ptr<const Program> program, ExecOptions options);

  // Runs until the script yields, waits or ends, or one due timer is done.
  // Returns false if nothing is left to do: the run has ended or failed.
  bool step();
  // The error that ended the run, if any.
  const std::optional<ExecFailure>& failure() const {
    return failure_;
  }

  // Yields after this many instructions instead of the default; for tests.
  void set_slice(std::uint64_t instructions) {
    interpreter_.set_slice(instructions);
  }
  // The time of the latest event.
  Timestamp now() const override {
    return now_;
  }
  std::size_t bytes_held() const {
    return interpreter_.bytes_held();
  }

  // The whole state of a run that has not failed: variables, call frames,
  // waits, timers, clock and random numbers. The format is described in
  // exec_state.cpp.
  std::string save() const;
  // Continues a saved run of the same program. Damaged bytes and bytes of
  // another program are an error of kind File.
  static Expected<std::unique_ptr<ExecRun>>
  restore(std::shared_ptr<const Program> program, ExecOptions options,
          std::string_view bytes);

private:
  // The end of time: the sum of two times stays within 64 bits.
  static constexpr Timestamp latest = Timestamp{1} << 60;
  static Timestamp later(Timestamp time, Milliseconds by) {
    return std::min(time + std::min(by.count(), latest), latest);
  }

  // What happens at a time: the body of a timer runs, or an activation that
  // waits is resumed.
  struct Due {
    Timestamp at = 0;
    std::uint64_t order = 0;
    std::string timer; // its name
    Milliseconds every{0};
    CodeId body = no_code;
    std::vector<Value> arguments;
    std::size_t bytes = 0; // of the arguments
    std::unique_ptr<Activation> waiting;
  };

  // The host's part of the run.
  Performed perform(Activation& activation, const Effect& effect) override;
  double random() override {
    return dice_.fraction();
  }

  // Each event has its own time and its own fuel.
  void begin_event();
  void start_main();
  void run_due(Due due);
  void go_on(RunResult result); // of the current activation
  // Removes what is due first.
  Due take_next();
  void cancel(const std::string& timer);
  Performed add_timer(const Effect& effect);
  Performed access_file(const FileRequest& request);

  static void write(ByteWriter& bytes, const Due& due);
  void read_timer(ByteReader& bytes, Due& due) const;
  void read_activations(ByteReader& bytes, Restored state, bool running);

  ExecOptions options_;
  Interpreter interpreter_;
  std::unique_ptr<Activation> current_; // has yielded
  std::vector<Due> due_;
  std::optional<ExecFailure> failure_;
  Random dice_;
  Timestamp now_ = 0;
  std::uint64_t order_ = 0;
  Milliseconds wait_{0}; // of the latest <wait>
  bool started_ = false;
};

// Runs to the end at once; returns nothing if no error occurred.
std::optional<ExecFailure> run_main(std::shared_ptr<const Program> program,
                                    ExecOptions options);

} // namespace parlour::script
