// `parlour exec`: the language without the dialogue (language rules 1.2 and
// 9.7). Prints and logs go to the given sinks, timers and waits run in the
// order of their times, files are read and written at once; everything else is
// an error of kind Refused.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/files.hpp"
#include "runtime/base/random.hpp"
#include "script/program/computing_host.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour {
class ByteReader;
class ByteWriter;
} // namespace parlour

namespace parlour::script {

struct ExecOptions {
  std::function<void(std::string_view)> print;
  std::function<void(std::string_view)> log;
  std::function<Timestamp()> now;
  // Returns at or after this time. Tests move a clock of their own.
  std::function<void(Timestamp)> wait_until;
  // Empty: there are no files, and statements that want them are refused.
  FileAccess files = {};
  std::uint64_t seed = 1;
  std::uint64_t instructions = defaults::exec_instructions; // of one event
};

struct ExecFailure {
  Error error;
  std::vector<std::string> stack; // innermost first
};

// A script's `main` and what it leaves behind, in steps: it may stop after
// each, be written to bytes, and go on from them in another process. Used by
// one thread.
class ExecRun : private LonelyHost {
public:
  ExecRun(std::shared_ptr<const Program> program, ExecOptions options);

  // Goes on until the script yields, waits or ends, or what was due is done.
  // False where nothing is left to do: it has ended or failed.
  bool step();
  // The first error ends it.
  const std::optional<ExecFailure>& failure() const {
    return failure_;
  }

  // Yields after so many instructions rather than the default.
  void set_slice(std::uint64_t instructions) {
    interpreter_.set_slice(instructions);
  }
  // The time of the event that ran last.
  Timestamp now() const override {
    return now_;
  }
  std::size_t bytes_held() const {
    return interpreter_.bytes_held();
  }

  // Everything of a run that has not failed: variables, frames, what waits,
  // timers, the clock and the dice. Its form: exec_state.cpp.
  std::string save() const;
  // The same run, with the same program; an error of kind File where the bytes
  // are damaged or another program's.
  static Expected<std::unique_ptr<ExecRun>>
  restore(std::shared_ptr<const Program> program, ExecOptions options,
          std::string_view bytes);

private:
  // Where time ends: sums of two times stay within 64 bits.
  static constexpr Timestamp latest = Timestamp{1} << 60;
  static Timestamp later(Timestamp time, Milliseconds by) {
    return std::min(time + std::min(by.count(), latest), latest);
  }

  // What goes on at a time: a timer's body, or an activation that waits.
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

  Performed perform(Activation& activation, const Effect& effect) override;
  double random() override {
    return dice_.fraction();
  }

  void begin_event();
  void start_main();
  void run_due(Due due);
  void go_on(RunResult result); // of the current activation
  Due take_next();
  void cancel(const std::string& timer);
  Performed add_timer(const Effect& effect);
  Performed access_file(const FileRequest& request);

  static void write(ByteWriter& bytes, const Due& due);
  void read_timer(ByteReader& bytes, Due& due) const;
  void read_activations(ByteReader& bytes, Restored state, bool running);

  ExecOptions options_;
  Interpreter interpreter_;
  std::unique_ptr<Activation> current_; // that yielded
  std::vector<Due> due_;
  std::optional<ExecFailure> failure_;
  Random dice_;
  Timestamp now_ = 0;
  std::uint64_t order_ = 0;
  Milliseconds wait_{0}; // of the <wait> that was performed last
  bool started_ = false;
};

// The whole run at once; nothing where all went well.
std::optional<ExecFailure> run_main(std::shared_ptr<const Program> program,
                                    ExecOptions options);

} // namespace parlour::script
