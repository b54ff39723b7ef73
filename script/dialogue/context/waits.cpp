#include "script/dialogue/context/waits.hpp"

#include <utility>

namespace parlour::dialogue {

void Waits::resume(WaitId wait, Expected<Value> outcome) {
  others_.forget_request(wait);
  if (context_.lane.waits(wait))
    context_.lane.wake(wait, outcome_step(wait, std::move(outcome)));
  else
    others_.resume_in_pipeline(wait, std::move(outcome));
}

StepList Waits::cancel(const std::vector<WaitId>& but) {
  auto waits = context_.lane.abandon(but);
  for (auto wait : others_.waits_in_pipeline())
    if (runner_.waits_for(wait) == ActivationRunner::WaitFor::user)
      waits.push_back(wait);
  StepList steps;
  for (auto wait : waits) {
    others_.forget_request(wait);
    steps.add(outcome_step(
        wait, fail(ErrorKind::cancelled, "the wait was cancelled")));
  }
  return steps;
}

} // namespace parlour::dialogue
