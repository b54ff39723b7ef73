// The messages about visits: seats that come and go, whose users number their
// turns. Part of the mailboxes of the session manager and of seats
// (interfaces.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "actors/protocol/in_flight.hpp"
#include "runtime/message/message.hpp"

namespace parlour::dialogue {
struct SavedSession; // script/dialogue/inputs/saved_session.hpp
} // namespace parlour::dialogue

namespace parlour::actors {

struct SeatCalls; // actors/sessions/seat.hpp

// To the session manager: open a seat of this name, and begin a conversation
// there; nobody waits. The seat hears of it by next_session before the
// conversation says anything.
struct begin_visit {
  std::string name;
  std::shared_ptr<const SeatCalls> calls;
  // One that goes on after a crash, under its id; null: a new one.
  std::shared_ptr<const dialogue::SavedSession> saved;
  InFlight work;
};
// To the session manager: close such a seat. Its session ends, then it leaves.
struct end_visit {
  std::string name;
  InFlight work;
};

// To the seat: the turns up to this number are answered, as far as no time has
// to pass for it (runtime/message/typed_turn.hpp).
struct turns_done {
  SessionId session;
  std::uint64_t turn;
  InFlight work;
};
// To a seat that is closed, the last message that it gets: quit.
struct leave_seat {
  InFlight work;
};

} // namespace parlour::actors
