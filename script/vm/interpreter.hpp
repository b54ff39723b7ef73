// Interpreter: runs the code of a program for one session; can stop at any
// instruction and go on later. Its state is plain data: session variables and
// activations. Not thread-safe: one session's interpreter is used by one
// thread at a time; the program is shared.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/message.hpp"
#include "script/program/host.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// What a running piece of script belongs to.
struct ActivationContext {
  std::shared_ptr<const Message> message; // being handled; may be null
  TopicId topic = no_id;                  // whose slots `this` means
  SlotId slot = no_id;                    // of a slot's own action
  std::uint64_t turn = 0;                 // the user turn that led here
  bool handles_error = false;             // it handles Script.Error
  bool writes = false; // its unnamed queries may write (language rule 11.12)
  bool leaves_state = false; // an Exit, or what stands in a <transit>
};

// A running or suspended piece of script: its frames and context.
class Activation {
public:
  virtual ~Activation() = default;
  const ActivationContext& context() const {
    return context_;
  }
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

enum class RunStatus {
  finished, // `value` is what it returned
  waiting,  // for the effect that it performed last
  yielded,  // its slice is used up; call run again
  failed,   // `error` was taken by no <catch>
};

struct RunResult {
  RunStatus status = RunStatus::finished;
  Value value;
  Error error;
  std::vector<std::string> stack; // "function f (file:line)", innermost first
};

// A body that was run and did not finish.
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

  // Computes the initial values of the session variables, in file order.
  Expected<void> initialise(Host& host);
  // The same where there is no session: those that fail stay unknown.
  void initialise_what_computes(Host& host);

  std::unique_ptr<Activation> start(CodeId code,
                                    const std::vector<Value>& arguments,
                                    ActivationContext context);
  // Starts and runs it. What finishes at once, as most bodies do, leaves
  // nothing behind, not even its value.
  std::optional<StoppedBody> run_body(CodeId code,
                                      const std::vector<Value>& arguments,
                                      ActivationContext context, Host& host);

  // Runs until it ends, waits, or has used up a slice. A fresh event's fuel is
  // counted from new_event().
  RunResult run(Activation& activation, Host& host);
  // Goes on after a wait with its outcome, or ends it with an error that a
  // <catch> may take.
  RunResult resume(Activation& activation, Expected<Value> outcome, Host& host);

  // Runs to the end at once; an effect that waits is an error of kind Refused.
  Expected<Value> evaluate(CodeId code, const std::vector<Value>& arguments,
                           ActivationContext context, Host& host);

  void new_event(); // refills the fuel (limits.instructions)
  // Instead of the settings' limits.instructions, from the next event on.
  void limit_instructions(std::uint64_t instructions);

  const Program& program() const;
  Value variable(std::size_t index) const;
  void set_variable(std::size_t index, Value value);

  // The whole state as bytes: session variables, what the event may still use,
  // and these activations, started here and none of them running. What they
  // share stays shared. Its form: interpreter_state.hpp.
  std::string save(const std::vector<const Activation*>& activations) const;
  // Goes on from there, in any process that compiled the same program; bytes
  // of another program or damaged ones are an error of kind File.
  static Expected<Restored> restore(std::shared_ptr<const Program> program,
                                    std::string_view bytes);

  // What the session's values and frames hold (limits.bytes).
  std::size_t bytes_held() const;
  // Yields after so many instructions rather than the default; for tests.
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
