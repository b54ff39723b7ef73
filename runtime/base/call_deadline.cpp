#include "runtime/base/call_deadline.hpp"

#include <algorithm>

namespace parlour {

Milliseconds call_deadline(const ComponentPolicy& policy,
                           Milliseconds request_timeout) {
  return policy.deadline.value_or(
      std::min(defaults::component_deadline, request_timeout / 2));
}

} // namespace parlour
