#include "script/dialogue/topic_engine/wait_ends.hpp"

namespace parlour::dialogue {

StepList WaitEnds::cancel(const std::vector<WaitId>& but) {
  confirmations_.cancel_confirms(but);
  refusals_.clear();
  enquiries_.forget();
  return waits_.cancel(but);
}

} // namespace parlour::dialogue
