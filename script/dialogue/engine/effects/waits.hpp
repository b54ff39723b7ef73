// Waits: the user wants out, or the session ends: what scripts and topics wait
// for is over (engine rule 2.5).
#pragma once

#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/engine/effects/outside_effects.hpp"
#include "script/dialogue/engine/effects/request_effects.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

// The parts that keep waits do not know one another; this one knows them all,
// and keeps nothing itself.
class Waits {
public:
  Waits(DialogueContext& context, const ActivationRunner& runner,
        RequestEffects& requests, OutsideEffects& outside, TopicEngine& topics)
      : context_(context), runner_(runner), requests_(requests),
        outside_(outside), topics_(topics) {}

  // What waits in the dialogue lane, and of these in the pipeline lane what
  // waits for the user, is to end with kind Cancelled, but the last ones. The
  // steps that tell them so, innermost first; pushed states are left to the
  // caller.
  [[nodiscard]] StepList cancel(const std::vector<WaitId>& in_pipeline,
                                const std::vector<WaitId>& but = {});
  // The answer that this wait is for is wanted no more.
  void forget_request(WaitId wait) {
    requests_.forget(wait);
    outside_.forget(wait);
  }

private:
  DialogueContext& context_;
  const ActivationRunner& runner_;
  RequestEffects& requests_;
  OutsideEffects& outside_;
  TopicEngine& topics_;
};

} // namespace parlour::dialogue
