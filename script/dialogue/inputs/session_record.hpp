// SessionRecord: what a journal keeps of a session, as bytes that can be listed
// without its program.
//
//   version   a byte, session_record_version
//   kind      a byte: the number of the alternative in SessionRecord
//   session   text, its id
//   opened    fixed, the program's identity; fixed, the session's seed;
//             a byte, whether its effects waited for the journal; block, the
//             name of its configured seat, empty for another
//   taken     block, the input; block, the port's answers (replay.hpp)
//   state     as opened; fixed, how many inputs it has taken; block, the bytes
//             of Conversation::save(); fixed, the turns taken and those that
//             are answered; fixed, how many outputs follow, and for each fixed,
//             its turn and its number; a byte, its act; text, its words
//   posted    fixed, how many inputs
//   closed    nothing
// A tool can list sessions, inputs and ends without the program that the blocks
// need to be read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"
#include "script/dialogue/inputs/turn_log.hpp"

namespace parlour::dialogue {

// To be raised with each change of the form above; records of another version
// are refused.
inline constexpr std::uint8_t session_record_version = 3;

// The session was made; its inputs follow, between those of others.
struct SessionOpened {
  std::uint64_t program = 0; // identity_of it
  std::uint64_t seed = 1;
  bool strict = false;   // its effects waited for the journal
  std::string seat = {}; // the configured one; empty: another
};

// One input, with what was answered at once; both as the bytes of replay.hpp.
struct InputTaken {
  std::string input;
  std::string answers;
};

// The session as it is: nothing before is needed to repeat what follows.
struct StateKept {
  SessionOpened opened;
  std::uint64_t inputs = 0; // that were taken before
  std::string state;
  TurnLog turns;
};

// The messages that the session posted during its first inputs, so many, are
// with those that they are for: after a crash they are not posted again. Of
// strict journals only.
struct EffectsDone {
  std::uint64_t inputs = 0;
};

// It is over: nothing of it goes on after a crash.
struct SessionClosed {};

// One entry of a journal: of which session, and what.
struct SessionRecord {
  SessionId session;
  std::variant<SessionOpened, InputTaken, StateKept, EffectsDone, SessionClosed>
      what;
};

std::string to_bytes(const SessionRecord& record);
// An error, of kind File, where the bytes are no record.
Expected<SessionRecord> read_record(std::string_view bytes);

} // namespace parlour::dialogue
