// What visitors and server say to each other, as data and as JSON (PROTOCOL.md
// is normative), and as lines for people. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters::web {

inline constexpr std::uint64_t protocol_version = 1;

// -- from a visitor -----------------------------------------------------------

// A program's first message. With `session` it comes back, and is told all that
// it has not seen.
struct Hello {
  std::string session;      // to be resumed; empty: a new one
  std::uint64_t turn = 0;   // the last one that was seen as done
  std::uint64_t output = 0; // the last one that was seen
};
struct Turn {
  std::uint64_t number = 0;
  std::vector<std::string> lines; // which arrive together; at least one
};
struct Goodbye {};
struct Ping {};

using Heard = std::variant<Hello, Turn, Goodbye, Ping>;

// Errors say what is wrong, where, and what is right instead.
Expected<Heard> read_heard(std::string_view text);
// Whether a first line begins the structured protocol.
bool is_structured(std::string_view line);
// What a person has typed, without its line end; the error says which byte is
// no UTF-8.
Expected<std::string> read_typed(std::string_view line);

// -- to a visitor -------------------------------------------------------------

struct Welcome {
  std::string session;
  std::uint64_t turn = 0; // the last one that was taken
  bool resumed = false;
  // Of a resumed session: some of what was said since is not kept any more.
  bool lost = false;
  std::string clock;         // what the platform's clock shows: local time
  std::uint64_t process = 0; // the server's number
};
// One output of the robot. Outputs of a session have rising numbers.
struct Said {
  std::uint64_t turn = 0; // that it answers; 0: said without being asked
  std::uint64_t output = 0;
  std::string act;
  std::string text;
};
// Nothing more comes of this turn, and of none before it, unless time passes.
struct Done {
  std::uint64_t turn = 0;
};
// The session is over.
struct Ended {};
struct Pong {};
// `code` is a word for programs, the rest for people.
struct Refused {
  std::string code;
  std::string message;
  std::uint64_t turn = 0; // 0: none
};

using Told = std::variant<Welcome, Said, Done, Ended, Pong, Refused>;

std::string to_json(const Told& told);
// For a person; empty where there is nothing to say.
std::string to_line(const Told& told);

} // namespace parlour::adapters::web
