// TimeEffects: what scripts want of the clock: <wait> and <timer>.
#pragma once

#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

class TimeEffects {
public:
  TimeEffects(DialogueContext& context, Timers& timers, RunningScript& running)
      : context_(context), timers_(timers), running_(running) {}

  script::Performed wait(const script::Effect& effect);
  // The topic is that of the script.
  script::Performed start_timer(TopicId topic, const script::Effect& effect);
  script::Performed stop_timer(const script::Effect& effect);

private:
  VisitId ends_with(const Value& said) const;

  DialogueContext& context_;
  Timers& timers_;
  RunningScript& running_;
};

} // namespace parlour::dialogue
