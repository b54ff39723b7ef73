// Host: the only interface between a script and the world (engine rule 7.2).
// Whatever leaves a script goes through perform(), and whatever it learns comes
// through these functions, so a script's run depends on nothing else and can be
// replayed.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

enum class EffectKind : std::uint8_t {
#define EFFECT(name, ...) name,
#include "script/program/effects.def"
#undef EFFECT
};

// A request of a script to the world. The operands are views of the script's
// registers and are converted when they are asked for; an Effect is valid only
// during perform().
class Effect {
public:
  explicit Effect(EffectKind what, std::span<const Box> operands = {},
                  std::span<const Box> captured = {})
      : kind(what), operands_(operands), captured_(captured) {}

  EffectKind kind;
  CodeId body = no_code; // of a timer or transit
  // The state or topic that operand 0 names if the name is a constant;
  // otherwise no_id.
  std::uint32_t target = no_id;
  Position position{};

  // An operand by its position in effects.def; unknown if there are fewer.
  Value operand(std::size_t index) const;
  // The same as operand(index).text() without making the value.
  std::string text(std::size_t index) const;
  // Whether the operand exists and is not unknown.
  bool has(std::size_t index) const;
  // The local variables that the body sees, as its arguments.
  std::vector<Value> captured() const;
  std::size_t operand_count() const {
    return operands_.size();
  }

private:
  std::span<const Box> operands_;
  std::span<const Box> captured_;
};

// The effect waits: the activation is suspended until it is resumed.
struct Waits {};

// The outcome of an effect: its value, a wait, or an error to throw.
using Performed = std::variant<Value, Waits, Error>;

// clang-format off
#define PARLOUR_SYSTEM_VARIABLES(X) \
  X(source, "_SOURCE") X(command, "_COMMAND") X(timestamp, "_TIMESTAMP") \
  X(params, "_LPARAMS") X(session, "_SESSION") X(state, "_STATE") \
  X(topic, "_TOPIC") X(slot, "_SLOT") X(frame_done, "_FrameDone") \
  X(error, "_ERROR")
// clang-format on

enum class SystemVariable : std::uint8_t {
#define X(name, text) name,
  PARLOUR_SYSTEM_VARIABLES(X)
#undef X
};

class Activation;

// Implemented by the conversation, by `parlour exec` and by computing_host.hpp.
// Called by the interpreter, in its thread.
//
// Calls may come at any instruction of a script, also nested: perform() may run
// another activation of the same interpreter before it returns.
class Host {
public:
  virtual ~Host() = default;

  // Performs an effect. An effect that waits returns Waits; the implementation
  // then resumes the activation later (Interpreter::resume).
  virtual Performed perform(Activation& activation, const Effect& effect) = 0;

  // Reads and sets `this.X`. The slot may be a pseudo-slot (program.hpp).
  virtual Value slot(TopicId topic, SlotId slot) const = 0;
  virtual void set_slot(TopicId topic, SlotId slot, Value value) = 0;

  // Reads a system variable (language rule 5.9). Those about the message come
  // from the activation, so only session, state, topic, slot and frame_done are
  // asked for here.
  virtual Value system(const Activation& activation,
                       SystemVariable variable) const = 0;
  virtual bool online(const std::string& agent) const = 0;

  // The time, which is constant within one event (language rule 8.8).
  virtual Timestamp now() const = 0;
  // A number in [0, 1), drawn from the session's own seed.
  virtual double random() = 0;
  // Whether reached() is wanted. The coverage instructions cost little if not.
  virtual bool watches_branches() const {
    return false;
  }
  // A branch, handler or action runs; for coverage reports.
  virtual void reached(Position) {}
};

} // namespace parlour::script
