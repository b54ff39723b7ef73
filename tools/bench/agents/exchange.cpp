#include "tools/bench/agents/exchange.hpp"

#include <algorithm>

namespace parlour::tools {

void set_one_way(Exchanged& exchanged, const StopWatch& watch,
                 std::size_t messages) {
  const auto measured = watch.stop(messages, {});
  exchanged.messages_per_second = 1e9 / measured.passed;
  exchanged.cpu_nanoseconds = measured.nanoseconds;
}

void set_round_trips(Exchanged& exchanged, std::vector<double> microseconds) {
  if (microseconds.empty())
    return;
  std::ranges::sort(microseconds);
  exchanged.median_microseconds = microseconds[microseconds.size() / 2];
  exchanged.p99_microseconds = microseconds[microseconds.size() * 99 / 100];
}

} // namespace parlour::tools
