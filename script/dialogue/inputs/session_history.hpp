// SessionHistory: what a journal has of one session, from its beginning or from
// a state that was kept.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "script/dialogue/inputs/session_record.hpp"

namespace parlour::dialogue {

// Filled record by record (take), in the order of the journal. A replay begins
// at `state` with the inputs behind it.
struct SessionHistory {
  SessionId id;
  SessionOpened opened;
  std::string state;        // where it begins; empty: with the session
  std::uint64_t before = 0; // inputs that were taken before that state
  // As it was at that state.
  TurnLog turns;
  std::vector<InputTaken> inputs;
  // What was posted during the first so many inputs of the session is with
  // those that it is for (EffectsDone).
  std::uint64_t posted = 0;
  bool closed = false;

  // How many inputs the session has taken.
  std::uint64_t count() const {
    return before + inputs.size();
  }
};

// From which records a history is made.
enum class HistoryFrom : std::uint8_t {
  beginning,  // all that there is
  last_state, // no more than is needed to go on
};

// Takes the next record of this session. False where it does not follow what
// came before, because a record is missing. The history is then of no use until
// a state follows.
bool take(SessionHistory& history, SessionRecord record, HistoryFrom from);

} // namespace parlour::dialogue
