// StateMachine: transitions (engine rule 4): Exit, the transit's children,
// Entrance; push and pop. One after the other: what is asked for while a state
// is being left comes when that is done. A transit from A to B is three steps
// of the dialogue lane: Leave (A's Exit), RunLeaving (the children of
// <transit>) and Enter (B, and its Entrance). Each of the scripts may wait, so
// the way can take several inputs. Until B is entered, that way is the
// `passage_`, and what others ask for is kept in `later_`.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/engine/effects/waits.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

// Owned by ConversationImplementation. It changes the StateStack; nothing else
// does, but take-over by another program. Each take() carries out one step and
// puts what follows in front of the lane.
class StateMachine {
public:
  StateMachine(DialogueContext& context, Timers& timers,
               ActivationRunner& runner, Waits& waits, TopicEngine& topics)
      : context_(context), timers_(timers), runner_(runner), waits_(waits),
        topics_(topics) {}

  // Replaces the state of the active level.
  void take(steps::Transit&& step);
  void take(const steps::Leave& step);
  void take(const steps::Enter& step);
  // A new level above the active one; the activation that pushed waits for
  // take(ComeBack).
  void take(steps::Push&& step);
  // Nothing where no state is pushed any more.
  void take(steps::Pop&& step);
  void take(const steps::ComeBack& step);
  // Ends this wait for the user as cancelled: a pushed state, and those that
  // were pushed from it, are left.
  void take(steps::GiveUp&& step);
  // Online of the active state, for agents that are there from the start.
  void take(const steps::GreetAgents& step);
  // The steps by which what was asked before in the same statements is given
  // up. Empty where nothing was asked before.
  StepList dropped_by(WaitId wait) const;
  // Online or Offline of the active state, for this agent or for any; false
  // where it has none, or where the event is another one.
  bool agent_changed(const Message& event);
  // Leaves every level without Exit (start over).
  void clear();
  // The pushed levels, whose activations were cancelled. The bottom level stays
  // as it is.
  void clear_pushed();
  // The Exit of every level, innermost first: how a session leaves its states
  // at its end.
  StepList exits() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, timers_, runner_, waits_, topics_);
    archive(passage_, later_);
  }

private:
  // An Online or Offline becomes an item of the dialogue lane.
  void react(const script::Reaction& reaction,
             std::shared_ptr<const Message> event);
  // Out of the pushed state: its Exit, then back.
  void begin_way_out(bool given_up);
  // A state is being left: the step comes later. True: it was moved from. Of
  // several transits the last counts.
  template <class Kind>
  bool comes_later(Kind& step);
  // On the active level: its Entrance runs, and what the state before has
  // started ends.
  void enter(StateId state);
  // No state is being left any more: what had to wait for that becomes items.
  void end_passage();
  // What their scripts have started ends with the states that were left.
  void forget_what_was_left();
  // Who pushed, or waits in a state that was left, goes on with this.
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
