#include "actors/routing/round_limit.hpp"

#include <utility>

namespace parlour::actors {

RoundLimit::Verdict RoundLimit::judge(const Message& message) {
  return message.rounds <= honest_rounds ? Verdict::passes : count(message);
}

// What was counted in an earlier second is forgotten for all sessions at once,
// so that the map stays small.
RoundLimit::Verdict RoundLimit::count(const Message& message) {
  const auto second = message.time / 1'000;
  const std::lock_guard lock(mutex_);
  if (std::exchange(second_, second) != second)
    seen_.clear();
  const auto seen = ++seen_[message.session];
  return seen <= each_second       ? Verdict::passes
         : seen == each_second + 1 ? Verdict::first_too_many
                                   : Verdict::too_many;
}

} // namespace parlour::actors
