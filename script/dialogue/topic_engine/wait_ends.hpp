// WaitEnds: the user wants out, or the session ends: what scripts and topics
// wait for is over (engine rule 2.5).
#pragma once

#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/waits.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/topic_engine/enquiries.hpp"
#include "script/dialogue/topic_engine/refusals.hpp"

namespace parlour::dialogue {

class WaitEnds {
public:
  WaitEnds(Waits& waits, Confirmations& confirmations, Refusals& refusals,
           Enquiries& enquiries)
      : waits_(waits), confirmations_(confirmations), refusals_(refusals),
        enquiries_(enquiries) {}

  // All waits, and all <confirm>s, are ended, but these (Waits::cancel).
  [[nodiscard]] StepList cancel(const std::vector<WaitId>& but = {});

private:
  Waits& waits_;
  Confirmations& confirmations_;
  Refusals& refusals_;
  Enquiries& enquiries_;
};

} // namespace parlour::dialogue
