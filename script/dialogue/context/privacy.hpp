// Privacy: tells the port what is private="true" of variables and slots, as it
// is printed and as it is spoken, before anybody who watches could see it. An
// internal header of this folder. What is once told stays hidden, also when the
// variable has another value later. Where a program has nothing private, it
// costs next to nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/frame/topic_frame.hpp"
#include "script/program/program.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// A part of the DialogueContext. Its errors are on the safe side: a text that
// also occurs elsewhere is hidden there, too.
class Privacy {
public:
  Privacy(const script::Program& program,
          const script::Interpreter& interpreter, Port& port);

  // Whether anything of the program is private at all.
  bool is_needed() const {
    return is_needed_;
  }
  // Private variables that have changed. Called before anything is shown,
  // raised or posted, as a script may have set them since.
  void note_variables(Timestamp now);
  // A slot's value, where it is private.
  void note(TopicId topic, SlotId slot, const Value& value, Timestamp now);
  // What slots are offered, whatever becomes of it.
  void note(TopicId topic, std::span<const FrameChange> changes, Timestamp now);
  // The user was heard: hidden where a private slot is asked for.
  void hear(bool is_asked_in_private);
  // Another port is told of the private variables.
  void resume(Timestamp now);
  // Everything that was received, up to that number, is understood: whoever
  // watches may see it now.
  void settle(std::uint64_t received);

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(program_, interpreter_, port_, is_needed_, variables_,
                    writes_);
    archive(known_);
    archive.check(known_.size() == variables_.size(),
                  "other variables are private");
  }

private:
  // But not what is in `told`.
  void conceal(const Value& value, const std::string& kind, Timestamp now,
               const Value& told = {});

  const script::Program& program_;
  const script::Interpreter& interpreter_;
  Port& port_;
  const bool is_needed_;
  std::vector<std::size_t> variables_; // the private ones
  // Their values when they were told last, in the same order.
  std::vector<Value> known_;
  // Interpreter::writes() then; none: not known.
  std::optional<std::uint64_t> writes_;
};

} // namespace parlour::dialogue
