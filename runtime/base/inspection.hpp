// What can be watched of a running session: each step of a message's way, each
// transition, slot change and output. Consumers (trace, console, coverage)
// never influence what happens.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "runtime/base/message.hpp"

namespace parlour {

// clang-format off
#define PARLOUR_INSPECTION_KINDS(X) \
  X(message, "a message and the way it took") \
  X(unhandled, "a message that nobody took") \
  X(transition, "a state was left for another") \
  X(topic, "a topic changed its status") \
  X(slot, "a slot changed its value") \
  X(output, "an output was queued, released or withdrawn") \
  X(error, "a script ended with an error") \
  X(cancelled, "a script that waited was ended from outside, as is usual") \
  X(log, "a script's <log>") \
  X(branch, "a branch, handler or slot action ran (coverage)")
// clang-format on

enum class InspectionKind : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_INSPECTION_KINDS(X)
#undef X
};

struct Inspection {
  InspectionKind kind = InspectionKind::log;
  SessionId session;
  std::string subject; // "Appointment.Time", "Welcome", "Record.BufferFull"
  std::string detail;  // human words
  // Of kinds message and unhandled: the message, and the way it took as
  // "filter -> NLG", "session"; else null and empty.
  std::shared_ptr<const Message> message = nullptr;
  std::string way = {};
};

} // namespace parlour
