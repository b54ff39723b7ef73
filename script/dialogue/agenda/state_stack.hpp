// StateStack: the active state, and those beneath it that pushed one as a
// subtask (engine rules 2 and 4). The bottom level may hold no state. Each
// entering of a state begins a visit, which ends when the state is left. For
// example, with <push state="Ringing"/> in the state "Welcome" there are two
// levels, and what is waited for with the upper one is the <push>.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "script/program/program.hpp"

namespace parlour::dialogue {

using script::StateId;
using script::TopicId;
// The same state that is entered again is another visit: what the scripts of
// the first one have started is over.
using VisitId = std::uint64_t; // 0: none
using WaitId = std::uint64_t;  // 0: none

// Plain data, owned by the DialogueContext. The StateMachine changes it;
// whoever wants to know where the conversation is reads it.
class StateStack {
public:
  struct Push { // an activation that pushed
    WaitId wait = 0;
    TopicId topic = script::no_id; // that it is of

    template <class Archive>
    void serialize(Archive& archive) {
      archive(wait);
      archive.topic(topic);
    }
  };
  // A state with its visit, and the <push> that it was entered by.
  struct Level {
    StateId state = script::no_id;
    VisitId visit = 0;
    Push by{}; // nothing for the bottom level

    template <class Archive>
    void serialize(Archive& archive) {
      archive.state(state);
      archive(visit, by);
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
    levels_.back().state = state;
    levels_.back().visit = state == script::no_id ? 0 : ++visits_;
  }
  // A level without a state as yet.
  void push(Push by) {
    levels_.push_back({.by = by});
  }
  Push pop() { // something was pushed
    const auto by = levels_.back().by;
    levels_.pop_back();
    return by;
  }
  // Whether the active level is a subtask. Only then may pop() be called.
  bool pushed() const {
    return levels_.size() > 1;
  }
  // Whether a script of that topic waits for a pushed state, or that wait is
  // for one.
  bool was_pushed_by(TopicId topic) const {
    return std::any_of(
        levels_.begin() + 1, levels_.end(),
        [&](const Level& level) { return level.by.topic == topic; });
  }
  bool was_pushed_for(WaitId wait) const {
    return std::any_of(
        levels_.begin() + 1, levels_.end(),
        [&](const Level& level) { return level.by.wait == wait; });
  }
  // Those of another conversation; at least one.
  void take_over(const StateStack& before, std::vector<Level> levels) {
    visits_ = before.visits_;
    levels_ = std::move(levels);
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
  VisitId visits_ = 0; // so far
  std::vector<Level> levels_{Level{}};
};

} // namespace parlour::dialogue
