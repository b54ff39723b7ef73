// StateMachine: transitions (engine rule 4): Exit, the transit's children,
// Entrance; push and pop. One after the other: what is asked for while a state
// is being left comes when that is done.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/waits.hpp"
#include "script/dialogue/topic_engine/pushed_states.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

class StateMachine final : public PushedStates {
public:
  StateMachine(DialogueContext& context, ActivationRunner& runner, Waits& waits,
               TopicEngine& topics)
      : context_(context), runner_(runner), waits_(waits), topics_(topics) {}

  void transit(Step&& step);
  void leave(const Step& step);
  void enter(const Step& step);
  void push(Step&& step);
  void pop(Step&& step);
  // Ends this wait for the user as cancelled: a pushed state, and those that
  // were pushed from it, are left.
  void give_up(Step&& step);
  // The steps by which what was asked before in the same statements is given
  // up.
  StepList dropped_by(WaitId wait) const;
  bool was_pushed_by(TopicId topic) const override;
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
  void clear_pushed() override;
  // The Exit of every level, innermost first.
  StepList exits() const;

private:
  void react(const script::Reaction& reaction,
             std::shared_ptr<const Message> event);
  StepList way_out(StateId state, std::uint64_t mark) const;
  void begin_way_out(std::uint64_t mark);
  // A state is being left: the step comes later.
  bool comes_later(Step& step);
  void end_passage();
  // What their scripts have started ends with the states that were left.
  void forget_what_was_left();
  void end_wait(WaitId wait, Expected<Value> outcome);

  DialogueContext& context_;
  ActivationRunner& runner_;
  Waits& waits_;
  TopicEngine& topics_;
  struct Push { // an activation that pushed
    WaitId wait = 0;
    TopicId topic = script::no_id; // that it is of
  };
  std::vector<Push> pushes_; // innermost last
  // While a state is being left: what will end that, and what comes then.
  std::optional<Step> passage_;
  std::vector<Step> later_;
};

} // namespace parlour::dialogue
