// Thoughts: what the engine made of the last turn and where it stands, from
// what can be watched of it; shown where a conversation goes wrong.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "runtime/base/inspection.hpp"

namespace parlour::tools {

class Thoughts {
public:
  // The user speaks: what was understood and happened before is forgotten.
  void begin_turn();
  void note(const Inspection& inspection);
  // A line each: what was understood, the state, the topics with their slots,
  // and what happened just before.
  std::vector<std::string> lines() const;

private:
  void note_message(const Inspection& inspection);

  static constexpr std::size_t most_recent = 12;

  std::string state_;
  std::vector<std::string> understood_;
  std::map<std::string, std::string> topics_; // name -> status
  std::map<std::string, std::map<std::string, std::string>> slots_; // of those
  std::deque<std::string> recent_;
};

} // namespace parlour::tools
