// Message: the one form of everything that passes the message centre, from
// events and commands to queries (engine rule 1).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/value.hpp"

namespace parlour {

// Identifies a conversation and is hard to guess; empty if a message belongs to
// none.
using SessionId = std::string;

// The number of the message that a message answers; 0 if it answers none.
using Correlation = std::uint64_t;

struct Message {
  std::int64_t time = 0;    // milliseconds since 1970; set by the centre
  std::uint64_t number = 0; // rising; set by the message centre
  std::string source;       // component instance, or a reserved source
  std::string command;      // the purpose
  std::vector<Value> params;
  std::vector<std::string> sinks; // role or name; empty: to the session
  SessionId session;
  Correlation correlation = 0;
  // How many messages lead from an outside event to this one (engine rule 1.6).
  std::uint32_t rounds = 0;

  bool operator==(const Message&) const = default;
};

// "Source.Command(param, …) -> sink", as traces and logs show it.
std::string to_string(const Message& message);

} // namespace parlour
