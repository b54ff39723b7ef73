// OneCore keeps the process on one core while it lives: threads that hand work
// to each other are then measured the same way in every run, and not by where
// the system happens to put them.
#pragma once

#include <sched.h>

namespace parlour::tools {

// Threads that are started meanwhile stay on the core, too. Has no effect where
// the system does not allow it.
class OneCore {
public:
  OneCore();
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;
  // Gives the calling thread back the cores that it had.
  ~OneCore();

private:
  cpu_set_t before_{};
};

} // namespace parlour::tools
