// What the system says of this process: memory, time, threads.
#pragma once

#include "runtime/base/metrics.hpp"

namespace parlour::tools {

// By the names that are usual for processes of any kind.
Metrics process_metrics();

} // namespace parlour::tools
