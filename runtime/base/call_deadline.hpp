// The time limit of one call into a component.
#pragma once

#include "runtime/base/clock.hpp"
#include "runtime/base/component_policy.hpp"

namespace parlour {

// The limit of one call into a component. A policy that sets a deadline
// decides. Without one the limit is the default, and at most half of
// `request_timeout`, so that a requester learns of a component that hangs while
// there is still time to ask another one.
Milliseconds call_deadline(const ComponentPolicy& policy,
                           Milliseconds request_timeout);

} // namespace parlour
