// TimeEffects: what scripts want of the clock: <wait> and <timer>.
#pragma once

#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// Keeps nothing: the timers are in Timers.
class TimeEffects {
public:
  TimeEffects(DialogueContext& context, Timers& timers, RunningScript& running)
      : context_(context), timers_(timers), running_(running) {}

  // An error of kind Limit where there are too many (language rule 9.6).
  script::Performed wait(const script::Effect& effect);
  // The topic is that of the script: `this` in the timer's statements means it.
  // Replaces a timer of the same name.
  script::Performed start_timer(TopicId topic, const script::Effect& effect);
  script::Performed stop_timer(const script::Effect& effect);

private:
  // The visit with which the timer ends; 0: with the session.
  VisitId ends_with(const Value& said) const;

  DialogueContext& context_;
  Timers& timers_;
  RunningScript& running_;
};

} // namespace parlour::dialogue
