// StateMachine: transitions (engine rule 4): Exit, the transit's children,
// Entrance; push and pop. One after the other: what is asked for while a state
// is being left comes when that is done.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/engine/waits.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

class StateMachine {
public:
  StateMachine(DialogueContext& context, Timers& timers,
               ActivationRunner& runner, Waits& waits, TopicEngine& topics)
      : context_(context), timers_(timers), runner_(runner), waits_(waits),
        topics_(topics) {}

  void take(steps::Transit&& step);
  void take(const steps::Leave& step);
  void take(const steps::Enter& step);
  void take(steps::Push&& step);
  void take(steps::Pop&& step);
  void take(const steps::ComeBack& step);
  // Ends this wait for the user as cancelled: a pushed state, and those that
  // were pushed from it, are left.
  void take(steps::GiveUp&& step);
  // Online of the active state, for agents that are there from the start.
  void take(const steps::GreetAgents& step);
  // The steps by which what was asked before in the same statements is given
  // up.
  StepList dropped_by(WaitId wait) const;
  // Online or Offline of the active state, for this agent or for any; false
  // where it has none.
  bool agent_changed(const Message& event);
  // Leaves every level without Exit (start over).
  void clear();
  // The pushed levels, whose activations were cancelled.
  void clear_pushed();
  // The Exit of every level, innermost first.
  StepList exits() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, timers_, runner_, waits_, topics_);
    archive(passage_, later_);
  }

private:
  void react(const script::Reaction& reaction,
             std::shared_ptr<const Message> event);
  // Out of the pushed state: its Exit, then back.
  void begin_way_out(bool given_up);
  // A state is being left: the step comes later.
  template <class Kind>
  bool comes_later(Kind& step);
  void enter(StateId state);
  void end_passage();
  // What their scripts have started ends with the states that were left.
  void forget_what_was_left();
  void end_wait(WaitId wait, Expected<Value> outcome);

  DialogueContext& context_;
  Timers& timers_;
  ActivationRunner& runner_;
  Waits& waits_;
  TopicEngine& topics_;
  // While a state is being left: what will end that, and what comes then.
  std::optional<Step> passage_;
  std::vector<Step> later_;
};

} // namespace parlour::dialogue
