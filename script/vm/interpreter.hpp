// Interpreter: runs the compiled code of a program for one session. It can stop
// at any instruction and continue later, also in another process. Its whole
// state is data: session variables, and activations with their call frames.
//
// It has no native stack between calls: frames are objects on the session's
// heap, so a thousand sessions can wait in a thousand scripts without a thread.
//
// Used by one thread at a time; the program is shared. An example:
//
//   Interpreter interpreter(program);
//   interpreter.initialise(host);
//   auto activation = interpreter.start(body, {}, context);
//   auto result = interpreter.run(*activation, host);
//   while (result.status == RunStatus::yielded)
//     result = interpreter.run(*activation, host);
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/message/message.hpp"
#include "script/program/host.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// The circumstances under which a piece of script runs.
struct ActivationContext {
  std::shared_ptr<const Message> message; // being handled; may be null
  TopicId topic = no_id;                  // whose slots `this` means
  SlotId slot = no_id;                    // of a slot's own action
  std::uint64_t turn = 0;                 // the user turn that led here
  bool handles_error = false;             // it handles Script.Error
  bool writes = false;                    // see language rule 11.12
  bool leaves_state = false;              // an Exit, or the body of <transit>
};

// A running or suspended piece of script: its call frames and its context. It
// must not outlive the interpreter that started it, except that destroying it
// is always safe.
class Activation {
public:
  virtual ~Activation() = default;
  const ActivationContext& context() const {
    return context_;
  }
  // Queries without a connection's name may write from now on (language rule
  // 11.12).
  void let_write(bool writes) {
    context_.writes = writes;
  }

protected:
  explicit Activation(ActivationContext context)
      : context_(std::move(context)) {}
  void set_context(ActivationContext context) {
    context_ = std::move(context);
  }

private:
  ActivationContext context_;
};

// Why a run returned.
enum class RunStatus {
  finished, // `value` is what it returned
  waiting,  // for the effect that it performed last
  yielded,  // the slice is used up; call run again
  failed,   // no <catch> took `error`
};

struct RunResult {
  RunStatus status = RunStatus::finished;
  Value value;
  Error error;
  std::vector<std::string> stack; // "function f (file:line)", innermost first
};

// A body that was run and is not finished.
struct StoppedBody {
  RunResult result;
  std::unique_ptr<Activation> activation;
};

struct Restored;

class Interpreter {
public:
  explicit Interpreter(std::shared_ptr<const Program> program);
  ~Interpreter();
  Interpreter(Interpreter&&) noexcept;
  Interpreter& operator=(Interpreter&&) noexcept;

  // Computes the initial values of the session variables in the order of the
  // files. Stops at the first error.
  Expected<void> initialise(Host& host);
  // The same without a session: a variable whose value cannot be computed stays
  // unknown.
  void initialise_what_computes(Host& host);

  // Prepares an activation without running it. The arguments are copied.
  std::unique_ptr<Activation> start(CodeId code,
                                    const std::vector<Value>& arguments,
                                    ActivationContext context);
  // Starts a body and runs it. A body that finishes at once, as most do,
  // returns nothing, and its value is dropped; its activation is reused.
  std::optional<StoppedBody> run_body(CodeId code,
                                      const std::vector<Value>& arguments,
                                      ActivationContext context, Host& host);

  // Runs until the activation ends, waits, or has used up a slice (engine rule
  // 2.7). All runs since the last new_event() share one event's fuel.
  RunResult run(Activation& activation, Host& host);
  // Continues after a wait with its outcome. An error is raised at the effect,
  // where a <catch> may take it.
  RunResult resume(Activation& activation, Expected<Value> outcome, Host& host);

  // Runs to the end without yielding. An effect that would wait is an error of
  // kind Refused.
  Expected<Value> evaluate(CodeId code, const std::vector<Value>& arguments,
                           ActivationContext context, Host& host);

  void new_event(); // refills the fuel (limits.instructions)
  // Replaces limits.instructions of the settings, from the next event on.
  void limit_instructions(std::uint64_t instructions);

  const Program& program() const;
  // Session variables by their index in Program::variables.
  Value variable(std::size_t index) const;
  void set_variable(std::size_t index, Value value);
  // How often session variables, or lists and maps, which may be in them, were
  // changed. While it stays the same, so do the variables.
  std::uint64_t writes() const;

  // The whole state as bytes: session variables, remaining fuel, and the given
  // activations, which this interpreter must have started and none of which may
  // be running. What they share stays shared (language rule 10.4). The format
  // is described in interpreter_state.hpp.
  std::string save(const std::vector<const Activation*>& activations) const;
  // Makes an interpreter from such bytes in any process that has compiled the
  // same program. Bytes of another program and damaged bytes are an error of
  // kind File.
  static Expected<Restored> restore(std::shared_ptr<const Program> program,
                                    std::string_view bytes);

  // The bytes that values and frames of the session take (limits.bytes).
  std::size_t bytes_held() const;
  // Yields after this many instructions instead of the default; for tests.
  void set_slice(std::uint64_t instructions);

private:
  Expected<void> initialise(std::size_t index, Host& host);

  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

struct Restored {
  Interpreter interpreter;
  std::vector<std::unique_ptr<Activation>> activations; // in their order
};

} // namespace parlour::script
