// RoundLimit: ends the rounds of those who answer each other for ever: relays
// that lead in a ring, a handler that posts what it is answered with. A message
// is a round further from what came from outside than the one that it was made
// from; one session's messages that are many rounds away, and are very many in
// a second, are such a ring: honest work of many steps takes its time.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>

#include "runtime/base/clock.hpp"
#include "runtime/message/message.hpp"

namespace parlour::actors {

// Safe from any thread.
// One of each node, shared by all of its tables (Counters). Messages without a
// session count together.
class RoundLimit {
public:
  // As a user's turn goes from the words to the voice.
  static constexpr std::uint32_t honest_rounds = 8;
  // Two components that answer each other reach this at once; a long
  // pipeline that is asked once a turn never does.
  static constexpr std::uint32_t each_second = 1'000;

  // `first_too_many` comes once in a second for each session: then an error is
  // shown.
  enum class Verdict : std::uint8_t { passes, first_too_many, too_many };
  Verdict judge(const Message& message);

private:
  Verdict count(const Message& message);

  std::mutex mutex_;
  std::int64_t second_ = 0;
  std::map<SessionId, std::uint32_t> seen_; // in that second
};

} // namespace parlour::actors
