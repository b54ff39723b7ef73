// Message: the one form of everything that goes through the message centre
// (paper III.A and III.E; engine rule 1).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/value.hpp"

namespace parlour {

// Names one conversation; hard to guess; empty where a message belongs to none.
using SessionId = std::string;

// The number of the message that a message answers, and that its own answers
// will carry; 0 is none.
using Correlation = std::uint64_t;

struct Message {
  std::int64_t time = 0;    // milliseconds since 1970; the centre's stamp
  std::uint64_t number = 0; // the centre's stamp, rising
  std::string source;       // component instance, or a reserved source
  std::string command;      // the purpose
  std::vector<Value> params;
  std::vector<std::string> sinks; // role or name; empty: to the session
  SessionId session;
  Correlation correlation = 0;
  // How many messages lie between it and what came from outside.
  std::uint32_t rounds = 0;

  bool operator==(const Message&) const = default;
};

// "Source.Command(param, …) -> sink" for traces and logs.
std::string to_string(const Message& message);

} // namespace parlour
