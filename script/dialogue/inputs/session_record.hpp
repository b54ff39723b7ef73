// SessionRecord: what a journal keeps of a session, as bytes that can be listed
// without its program.
//
//   version   a byte, session_record_version
//   kind      a byte: 0 opened, 1 taken
//   session   text, its id
//   opened    fixed, the program's identity; fixed, the session's seed
//   taken     block, the input; block, the port's answers (replay.hpp)
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::dialogue {

inline constexpr std::uint8_t session_record_version = 1;

// The session was made; its inputs follow, between those of others.
struct SessionOpened {
  std::uint64_t program = 0; // identity_of it
  std::uint64_t seed = 1;
};

// One input, with what was answered at once.
struct InputTaken {
  std::string input;
  std::string answers;
};

struct SessionRecord {
  SessionId session;
  std::variant<SessionOpened, InputTaken> what;
};

std::string to_bytes(const SessionRecord& record);
// An error, of kind File, where the bytes are no record.
Expected<SessionRecord> read_record(std::string_view bytes);

} // namespace parlour::dialogue
