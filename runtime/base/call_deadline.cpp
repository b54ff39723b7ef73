#include "runtime/base/call_deadline.hpp"

#include <algorithm>

namespace parlour {

Milliseconds call_deadline(const Upkeep& upkeep, Milliseconds request_timeout) {
  if (upkeep.deadline != defaults::component_deadline)
    return upkeep.deadline;
  return std::min(upkeep.deadline, request_timeout / 2);
}

} // namespace parlour
