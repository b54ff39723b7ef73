// Waits: how a script that waits goes on, in whichever lane it waits, and how
// waits are ended.
#pragma once

#include <vector>

#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"

namespace parlour::dialogue {

class Waits {
public:
  // Those that know of waits beside the dialogue lane.
  class Others {
  public:
    // An activation of the pipeline lane goes on; nothing where the wait is
    // none of its.
    virtual void resume_in_pipeline(WaitId wait, Expected<Value> outcome) = 0;
    virtual std::vector<WaitId> waits_in_pipeline() const = 0;
    // The answer that this wait is for is wanted no more.
    virtual void forget_request(WaitId wait) = 0;

  protected:
    ~Others() = default;
  };

  Waits(DialogueContext& context, const ActivationRunner& runner,
        Others& others)
      : context_(context), runner_(runner), others_(others) {}

  void resume(WaitId wait, Expected<Value> outcome);
  // The user wants out, or the session ends: what waits in the dialogue lane,
  // and what waits for the user anywhere, is to end with kind Cancelled
  // (engine rule 2), but these. The steps that tell them so, innermost first;
  // pushed states are left to the caller.
  [[nodiscard]] StepList cancel(const std::vector<WaitId>& but = {});
  void forget_request(WaitId wait) {
    others_.forget_request(wait);
  }

private:
  DialogueContext& context_;
  const ActivationRunner& runner_;
  Others& others_;
};

} // namespace parlour::dialogue
