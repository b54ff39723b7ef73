#include "script/dialogue/engine/lane_entry.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

namespace {

bool is_in_front(const Step& step) {
  const auto* taken = std::get_if<steps::TakeAct>(&step);
  return taken && passes_waits(*taken->act);
}

} // namespace

void LaneEntry::take(StepList acts, TurnId turn, WaitId wait) {
  if (wait != 0)
    acts.prepend(machine_.dropped_by(wait));
  if (acts.empty())
    return;
  if (std::any_of(acts.begin(), acts.end(), is_in_front) &&
      context_.lane.held()) {
    context_.lane.now(topics_.cancel_waits(topics_.confirms_but_of({})));
    machine_.clear_pushed();
  }
  acts.add(steps::Conclude{turn});
  context_.lane.queue(std::move(acts));
}

} // namespace parlour::dialogue
