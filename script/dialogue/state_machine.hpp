// StateMachine: transitions (engine rule 4): Exit, the transit's children,
// Entrance; push and pop.
#pragma once

#include "script/dialogue/step_list.hpp"

namespace parlour::dialogue {

struct Core;

class StateMachine {
public:
  explicit StateMachine(Core& core) : core_(core) {}

  void transit(Step&& step);
  void leave(const Step& step);
  void enter(const Step& step);
  void push(const Step& step);
  void pop(const Step& step);
  bool is_pushed() const {
    return !pushes_.empty();
  }
  // Online or Offline of the active state, for this agent or for any; false
  // where it has none.
  bool agent_changed(const Message& event);
  // Online of the active state, for agents that are there from the start.
  void greet_agents();
  // Leaves every level without Exit (start over).
  void clear();
  // Leaves the pushed levels, whose activations were cancelled.
  void clear_pushed();
  // The Exit of every level, innermost first.
  StepList exits() const;

private:
  void react(const script::Reaction& reaction,
             std::shared_ptr<const Message> event);
  StepList way_out(StateId state) const;

  Core& core_;
  struct Push { // an activation that pushed
    WaitId wait = 0;
    TopicId topic = script::no_id; // that it is of
  };
  std::vector<Push> pushes_; // innermost last
};

} // namespace parlour::dialogue
