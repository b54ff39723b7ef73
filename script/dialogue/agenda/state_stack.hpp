// StateStack: the active state, and those beneath it that pushed one as a
// subtask (engine rules 2 and 4). The bottom level may hold no state. Each
// entering of a state begins a visit, which ends when the state is left.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "script/program/program.hpp"

namespace parlour::dialogue {

using script::StateId;
using VisitId = std::uint64_t; // 0: none

class StateStack {
public:
  struct Level {
    StateId state = script::no_id;
    VisitId visit = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive.state(state);
      archive(visit);
    }
  };

  StateId active() const {
    return levels_.back().state;
  }
  VisitId visit() const { // of the active state
    return levels_.back().visit;
  }
  // Whether that visit still lasts, on whatever level.
  bool lasts(VisitId visit) const {
    return std::any_of(levels_.begin(), levels_.end(), [&](const Level& level) {
      return level.visit == visit;
    });
  }
  void enter(StateId state) { // on the same level
    levels_.back() = begin(state);
  }
  void push(StateId state) {
    levels_.push_back(begin(state));
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
  const std::vector<Level>& levels() const { // innermost last
    return levels_;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(visits_, levels_);
    archive.check(!levels_.empty(), "there is no level of states");
  }

private:
  Level begin(StateId state) {
    return {state, state == script::no_id ? 0 : ++visits_};
  }

  VisitId visits_ = 0; // so far
  std::vector<Level> levels_{Level{}};
};

} // namespace parlour::dialogue
