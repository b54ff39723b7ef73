// Host: the one door by which everything leaves a script and comes back
// (engine rule 7.2). The conversation implements it; the interpreter knows
// nothing else of the world.
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
#define EFFECT(name, waits, operands, sentence) name,
#include "script/program/effects.def"
#undef EFFECT
};

// What a script wants of the world. Its operands are the script's own
// registers, copied out when they are looked at: valid while it is performed,
// and no longer.
class Effect {
public:
  explicit Effect(EffectKind what, std::span<const Box> operands = {},
                  std::span<const Box> captured = {})
      : kind(what), operands_(operands), captured_(captured) {}

  EffectKind kind;
  CodeId body = no_code; // of timer and transit
  // The state or topic that operand 0 names, where the name stands in the
  // script; else no_id.
  std::uint32_t target = no_id;
  Position position{};

  // As effects.def names them; unknown where there are fewer.
  Value operand(std::size_t index) const;
  // operand(index).text(), without the value in between.
  std::string text(std::size_t index) const;
  // Whether it is there and not unknown.
  bool has(std::size_t index) const;
  // The body's arguments: visible locals.
  std::vector<Value> captured() const;
  std::size_t operand_count() const {
    return operands_.size();
  }

private:
  std::span<const Box> operands_;
  std::span<const Box> captured_;
};

// The activation goes on when the conversation resumes it.
struct Waits {};

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

class Host {
public:
  virtual ~Host() = default;

  virtual Performed perform(Activation& activation, const Effect& effect) = 0;

  // `this.X`; the slot may be a pseudo-slot.
  virtual Value slot(TopicId topic, SlotId slot) const = 0;
  virtual void set_slot(TopicId topic, SlotId slot, Value value) = 0;

  // Those of the message come from the activation; the host is asked for
  // session, state, topic, slot and frame_done.
  virtual Value system(const Activation& activation,
                       SystemVariable variable) const = 0;
  virtual bool online(const std::string& agent) const = 0;

  // Constant within one event.
  virtual Timestamp now() const = 0;
  // In [0, 1); from the session's seed.
  virtual double random() = 0;
  // Whether reached() is to be called.
  virtual bool watches_branches() const {
    return false;
  }
  // A branch, handler or action that ran, for coverage.
  virtual void reached(Position) {}
};

} // namespace parlour::script
