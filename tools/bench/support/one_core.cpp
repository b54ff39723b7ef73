#include "tools/bench/support/one_core.hpp"

namespace parlour::tools {

// The last of the cores that the process may use: the first ones have more of
// the system's own work.
OneCore::OneCore() {
  CPU_ZERO(&before_);
  if (sched_getaffinity(0, sizeof before_, &before_) != 0)
    return;
  for (std::size_t core = CPU_SETSIZE; core-- > 0;)
    if (CPU_ISSET(core, &before_)) {
      cpu_set_t one;
      CPU_ZERO(&one);
      CPU_SET(core, &one);
      sched_setaffinity(0, sizeof one, &one);
      return;
    }
}

OneCore::~OneCore() {
  if (CPU_COUNT(&before_) > 0)
    sched_setaffinity(0, sizeof before_, &before_);
}

} // namespace parlour::tools
