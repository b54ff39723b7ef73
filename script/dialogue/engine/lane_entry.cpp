#include "script/dialogue/engine/lane_entry.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"

namespace parlour::dialogue {

namespace {

bool is_in_front(const Step& step) {
  return step.kind == StepKind::take_act && passes_waits(*step.act);
}

} // namespace

void LaneEntry::take(StepList steps, TurnId turn) {
  if (steps.empty())
    return;
  if (std::any_of(steps.begin(), steps.end(), is_in_front) &&
      context_.lane.held()) {
    context_.lane.now(topics_.cancel_waits(topics_.confirms_but_of({})));
    pushed_states_.clear_pushed();
  }
  steps.push_back(conclude_step(turn));
  context_.lane.queue(std::move(steps));
}

} // namespace parlour::dialogue
