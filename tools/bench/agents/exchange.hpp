// What one contestant of `parlour bench agents` has measured, and the size of
// all messages.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

inline constexpr std::size_t exchanged_bytes = 256;

// How often a run repeats what it measures.
struct ExchangeCount {
  std::size_t messages = 0;    // one way, as fast as they can
  std::size_t round_trips = 0; // one after the other
};

// Time by the clock: threads wait for each other, and that is part of it.
struct Exchanged {
  double messages_per_second = 0;
  // CPU time of a message, of both sides and in the system.
  double cpu_nanoseconds = 0;
  // Of a round trip.
  double median_microseconds = 0;
  double p99_microseconds = 0;
};

// Fills in the figures of messages one way. It is called with a watch that has
// been running since the first of them.
void set_one_way(Exchanged& exchanged, const StopWatch& watch,
                 std::size_t messages);
// Fills in the figures of the round trips.
void set_round_trips(Exchanged& exchanged, std::vector<double> microseconds);

} // namespace parlour::tools
