// RestRound: which sessions are told to rest if they are idle, and when (engine
// rule 7.14). Some at a time: to write one down takes some 50 µs, and turns do
// not wait for many of them. Pure; the session manager asks it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include <caf/abstract_actor.hpp>
#include <caf/actor_control_block.hpp>

#include "runtime/base/clock.hpp"

namespace parlour::actors {

class RestRound {
public:
  static constexpr std::size_t at_once = 128;
  static constexpr Milliseconds between{10};
  // How soon changed scripts are noticed, where those before let nobody rest.
  static constexpr Milliseconds look_again{60'000};

  // The next ones of all, in the order in which they opened.
  template <class Entry>
  std::vector<const Entry*> next(const std::map<caf::actor_id, Entry>& sessions,
                                 Milliseconds rest_after) {
    std::vector<const Entry*> told;
    if (!may_rest(rest_after))
      return told;
    auto one = sessions.upper_bound(behind_);
    for (; one != sessions.end() && told.size() < at_once; ++one) {
      told.push_back(&one->second);
      behind_ = one->first;
    }
    if (one == sessions.end())
      behind_ = caf::invalid_actor_id;
    return told;
  }

  // Until next() is to be asked. All are told twice in `rest_after`, so that a
  // session rests when it has been idle for at most one and a half times that
  // long. 0: nobody rests.
  Milliseconds until_next(Milliseconds rest_after) const {
    if (!may_rest(rest_after))
      return look_again;
    return behind_ == caf::invalid_actor_id ? std::max(rest_after / 2, between)
                                            : between;
  }

private:
  static bool may_rest(Milliseconds rest_after) {
    return rest_after > Milliseconds::zero();
  }

  // The last one that was told; invalid: a round begins.
  caf::actor_id behind_ = caf::invalid_actor_id;
};

} // namespace parlour::actors
