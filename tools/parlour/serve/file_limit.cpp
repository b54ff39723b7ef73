#include "tools/parlour/serve/file_limit.hpp"

#include <algorithm>

#include <sys/resource.h>

namespace parlour::tools {

// The soft limit may be raised up to the hard one without any privilege; what
// came of it is read again.
std::size_t room_for_connections(std::size_t wanted, std::size_t others) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0)
    return wanted;
  const rlim_t needed = wanted + others;
  if (limit.rlim_cur < needed) {
    limit.rlim_cur = std::min(needed, limit.rlim_max);
    setrlimit(RLIMIT_NOFILE, &limit);
    getrlimit(RLIMIT_NOFILE, &limit);
  }
  const std::size_t room =
      limit.rlim_cur > others ? limit.rlim_cur - others : 0;
  return std::min(wanted, room);
}

} // namespace parlour::tools
