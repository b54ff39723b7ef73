// ActorStatus: what an actor says of itself when it is asked how it is;
// ActorHandle: whom to ask; get_status: the question.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <caf/actor_control_block.hpp>
#include <caf/replies_to.hpp>

#include "runtime/base/clock.hpp"

namespace parlour::actors {

// Shown by `parlour status` and by the metrics; nothing in the program depends
// on it.
struct ActorStatus {
  std::string kind;      // "session": what its state struct calls it
  std::string name;      // its own: a component's, a session's id; may be empty
  std::string doing;     // in words
  std::size_t queue = 0; // messages that it has not come to
  std::string last_error; // empty: none
  // It is in a call into foreign code since then.
  std::optional<Timestamp> call_since = std::nullopt;
  // False: it did not say this itself in time.
  bool answered = true;
};

// Keeps the actor alive while it is asked.
struct ActorHandle {
  std::string kind;
  std::string name;
  caf::strong_actor_ptr actor;
  // The call that it is in, from any thread: one that is in a call does not
  // answer. May be empty: nobody knows.
  std::function<std::optional<Timestamp>()> call_since = {};
};

// Say how you are. It holds no work: who asks does not make the node busy.
struct get_status {
  std::uint64_t number; // comes back with the answer
  bool with_children = true;
};
// How it is, and whom it has spawned for its own purposes.
struct status_told {
  std::uint64_t number;
  ActorStatus status;
  std::vector<ActorHandle> children = {};
};
// What every actor understands, beside its own messages.
using tells_status = caf::replies_to<get_status>::with<status_told>;

} // namespace parlour::actors
