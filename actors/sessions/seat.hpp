// A seat: a place where one conversation at a time happens (engine rule 7.1).
// This one shows what is said by calling back; text is heard at once.
#pragma once

#include <string>
#include <vector>

#include "actors/routing/session_directory.hpp"
#include "actors/support/node_time.hpp"
#include "actors/support/observer.hpp"
#include "runtime/base/settings.hpp"
#include "runtime/base/text/text_map.hpp"
#include "script/dialogue/agenda/output_queue.hpp"

namespace parlour::actors {

// Called on the seat's own actor thread, one at a time. What they throw is
// logged.
struct SeatCalls {
  std::function<void(const SessionId&, const dialogue::Output&)> on_say;
  std::function<void(const SessionId&)> on_over;
  // A session that opened by itself, for turns that the last one left unread,
  // or one that a visitor has begun (begin_visit).
  std::function<void(const SessionId&)> on_next = {};
  // What was said to it in turns with numbers up to this one is answered.
  std::function<void(const SessionId&, std::uint64_t turn)> on_turns_done = {};
};

// All of it outlives the seat.
struct SeatParts {
  const NodeTime* time = nullptr;
  Observer* observer = nullptr;
  const SessionDirectory* sessions = nullptr;
  std::string name = {};
};

// All that it has: its handlers, of which each seat has its own, keep nothing.
struct seat_state {
  static inline const char* name = "seat";
  SeatParts parts;
  SeatCalls calls;
  SessionId session; // that spoke here last; empty: it is over
};

// Each output is answered by output_done, also where it could not be shown: the
// session would wait for ever otherwise. Where the session has a loudspeaker,
// it does not take this as the end of the speech (engine rule 3.8).
seat_actor::behavior_type seat(seat_actor::stateful_pointer<seat_state> self,
                               SeatParts parts, SeatCalls calls);

// What the settings call this one of a node's seats; empty: it is none of
// theirs.
std::string configured_name(const seat_actor& seat,
                            const TextMap<seat_actor>& seats,
                            const std::vector<SeatSettings>& configured);

} // namespace parlour::actors
