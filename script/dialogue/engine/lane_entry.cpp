#include "script/dialogue/engine/lane_entry.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"

namespace parlour::dialogue {

namespace {

bool wants_out(const Step& step) {
  return step.kind == StepKind::take_act &&
         (step.act->kind == ActKind::cancel ||
          step.act->kind == ActKind::abandon ||
          step.act->kind == ActKind::restart);
}

} // namespace

void LaneEntry::take(StepList steps, TurnId turn) {
  if (steps.empty())
    return;
  if (std::any_of(steps.begin(), steps.end(), wants_out) &&
      context_.lane.held()) {
    context_.lane.now(topics_.cancel_waits(topics_.confirms_but_of({})));
    pushed_states_.clear_pushed();
  }
  steps.push_back(conclude_step(turn));
  context_.lane.queue(std::move(steps));
}

} // namespace parlour::dialogue
