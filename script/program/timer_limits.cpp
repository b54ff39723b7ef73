#include "script/program/timer_limits.hpp"

#include "runtime/base/value_bytes.hpp"

namespace parlour::script {

std::size_t remembered(const std::vector<Value>& locals) {
  std::size_t bytes = 0;
  for (const auto& local : locals)
    bytes += to_bytes(local).size();
  return bytes;
}

std::optional<Error> refuse_timers(std::size_t count, std::size_t bytes,
                                   std::size_t limit) {
  if (count > max_timers)
    return Error{ErrorKind::limit,
                 "more than " + std::to_string(max_timers) + " timers at once",
                 {}};
  if (bytes > limit)
    return Error{ErrorKind::limit,
                 "what the timers remember takes more than " +
                     std::to_string(limit) + " bytes",
                 {}};
  return {};
}

} // namespace parlour::script
