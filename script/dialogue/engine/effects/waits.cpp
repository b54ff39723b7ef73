#include "script/dialogue/engine/effects/waits.hpp"

#include <utility>

namespace parlour::dialogue {

// Handlers that wait for a component are left alone: what they do may have
// nothing to do with what the user wants out of (engine rule 2.5). The
// activations are not ended here but by steps, so that each <catch> runs in its
// lane and in order.
StepList Waits::cancel(const std::vector<WaitId>& in_pipeline,
                       const std::vector<WaitId>& but) {
  topics_.forget_waits(but);
  auto waits = context_.lane.abandon(but);
  for (auto wait : in_pipeline)
    if (runner_.waits_for(wait) == WaitFor::user)
      waits.push_back(wait);
  StepList steps;
  for (auto wait : waits) {
    forget_request(wait);
    steps.add(outcome_step(
        wait, fail(ErrorKind::cancelled, "the wait was cancelled")));
  }
  return steps;
}

} // namespace parlour::dialogue
