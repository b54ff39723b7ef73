// FailureContext: what the engine understood in the last user turn, and its
// state, topics and slots. It is collected from a node's inspections and
// printed where a conversation test fails. Not thread-safe; a node delivers
// inspections one at a time.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "runtime/message/inspection.hpp"

namespace parlour::tools {

class FailureContext {
public:
  // A user turn begins: forgets what was understood and what has happened.
  // State, topics and slots stay.
  void begin_turn();
  // Takes an inspection of any kind; those of coverage are ignored.
  void note(const Inspection& inspection);
  // One line for each act understood, the state, each topic with its slots, and
  // each recent event, in this order.
  std::vector<std::string> lines() const;

private:
  // FrameInfo and NoResult, as the NLU component fires them.
  void note_message(const Inspection& inspection);

  static constexpr std::size_t max_recent = 12; // events that lines() shows

  std::string state_;                         // empty: none yet
  std::vector<std::string> understood_;       // acts of this turn, as text
  std::map<std::string, std::string> topics_; // name -> status
  // By topic and slot.
  std::map<std::string, std::map<std::string, std::string>> slots_;
  std::deque<std::string> recent_; // trace lines
};

} // namespace parlour::tools
