// Privacy: tells the port what is private="true" of variables and slots, as it
// is printed and as it is spoken, before anybody who watches could see it. An
// internal header of this folder.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "script/dialogue/frame/frame.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

struct Core;

class Privacy {
public:
  explicit Privacy(Core& core);

  // Private variables that have changed.
  void note_variables();
  // A slot's value, where it is private.
  void note(TopicId topic, SlotId slot, const Value& value);
  // What slots are offered, whatever becomes of it.
  void note(TopicId topic, std::span<const FrameChange> changes);
  // The user was heard: hidden where a private slot is asked for.
  void hear();
  // Everything that was received is understood.
  void settle(std::uint64_t received);

private:
  void conceal(const Value& value, const std::string& kind);
  void collect(const Value& value, const std::string& kind,
               std::vector<std::string>& texts) const;

  Core& core_;
  const bool is_needed_;
  std::vector<std::size_t> variables_; // the private ones
  std::vector<Value> known_;           // as they were last
};

} // namespace parlour::dialogue
