// StateStack: the active state, and those beneath it that pushed one as a
// subtask (engine rules 2 and 4). The bottom level may hold no state.
#pragma once

#include <vector>

#include "script/program.hpp"

namespace parlour::dialogue {

using script::StateId;

class StateStack {
public:
  StateId active() const {
    return levels_.back();
  }
  void enter(StateId state) { // on the same level
    levels_.back() = state;
  }
  void push(StateId state) {
    levels_.push_back(state);
  }
  // False where nothing was pushed.
  bool pop() {
    if (!pushed())
      return false;
    levels_.pop_back();
    return true;
  }
  bool pushed() const {
    return levels_.size() > 1;
  }
  const std::vector<StateId>& levels() const { // innermost last
    return levels_;
  }

private:
  std::vector<StateId> levels_{script::no_id};
};

} // namespace parlour::dialogue
