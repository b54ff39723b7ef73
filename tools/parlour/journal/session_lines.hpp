// SessionLines: what happens in a session that is repeated, as lines of text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/message/message.hpp"
#include "script/dialogue/inputs/session_history.hpp"

namespace parlour::tools {

enum class LineForm : std::uint8_t {
  transcript, // for people
  test,       // a conversation file (docs/test.md)
  json,       // an object a line
};

// What a line tells of.
// Times in milliseconds of the session's own clock.
struct LinePlace {
  std::uint64_t input = 0; // its number, from 1
  Timestamp now = 0;
};

// Called by a replay for each input and output, in order; it prints nothing
// itself. What is private, the caller masks.
//
// The same turn in the three forms:
//
//   transcript   U: 10:30am.
//   test         wait 2000ms, then U: 10:30am.
//   json         {"session": ..., "kind": "message", "user": "10:30am."}
class SessionLines {
public:
  using Lines = std::vector<std::string>;

  explicit SessionLines(LineForm form) : form_(form) {}

  // `begins`: the time of the first input that is left.
  Lines heading(const dialogue::SessionHistory& history, Timestamp begins);
  // What the user said; the last line has the words, so that it may be hidden.
  Lines user(const LinePlace& place, const std::string& words);
  Lines robot(const LinePlace& place, const std::string& words);
  // Something that a component reported without being asked.
  Lines event(const LinePlace& place, const Message& message);
  // Any other input, by its name.
  Lines other(const LinePlace& place, std::string_view name);
  // The same as user(), of words that nobody is shown.
  std::string hidden(const LinePlace& place) const;

private:
  Lines with_wait(const LinePlace& place, Lines of_input);

  const LineForm form_;
  std::string session_;
  std::optional<Timestamp> last_; // when something was said or heard
};

} // namespace parlour::tools
