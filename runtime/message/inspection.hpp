// Inspection: one record of what happens in a running session: a message's way,
// a transition, a slot's change, an output. Traces, the console and the
// coverage report consume the records and never influence what happens.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "runtime/message/message.hpp"

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
  X(actor, "an actor took a message that is traced") \
  X(branch, "a branch, handler or slot action ran (coverage)")
// clang-format on

enum class InspectionKind : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_INSPECTION_KINDS(X)
#undef X
};

// Immutable once made; may be handed to another thread.
struct Inspection {
  InspectionKind kind = InspectionKind::log;
  SessionId session;
  std::string subject; // "Appointment.Time", "Welcome", "Record.BufferFull"
  std::string detail;  // a text for people
  // For the kinds `message` and `unhandled` only: the message, and the way it
  // took, such as "filter -> NLG" or "session". Otherwise null and empty.
  std::shared_ptr<const Message> message = nullptr;
  std::string way = {};
  // The user's turn that its session has taken last; 0: none, or nobody knows.
  std::uint64_t turn = 0;
};

// For the end of a line of a log: "  (session s1, turn 3)"; empty where it is
// about no session.
std::string concern_of(const Inspection& seen);

} // namespace parlour
