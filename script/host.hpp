// Host: the one door by which everything leaves a script and comes back
// (session.md, "Everything that enters is an input"). The conversation
// implements it; the interpreter knows nothing else of the world.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"
#include "script/program.hpp"

namespace parlour::script {

enum class EffectKind : std::uint8_t {
#define EFFECT(name, waits, operands, sentence) name,
#include "script/effects.def"
#undef EFFECT
};

// The operands of an effect: few, and without memory of their own.
class Operands {
public:
  static constexpr std::size_t most = 4;

  Operands() = default;
  Operands(std::initializer_list<Value> values) {
    for (const auto& value : values)
      push_back(value);
  }
  void push_back(Value value) {
    assert(size_ < most);
    values_[size_++] = std::move(value);
  }
  std::size_t size() const {
    return size_;
  }
  const Value& operator[](std::size_t index) const {
    return values_[index];
  }

private:
  std::array<Value, most> values_;
  std::size_t size_ = 0;
};

struct Effect {
  EffectKind kind = EffectKind::log;
  Operands operands;           // as effects.def names them
  CodeId body = no_code;       // of timer and transit
  std::vector<Value> captured; // the body's arguments: visible locals, copied
  Position position;

  // Unknown where there are fewer operands.
  const Value& operand(std::size_t index) const;
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

  virtual Performed perform(Activation& activation, Effect effect) = 0;

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
