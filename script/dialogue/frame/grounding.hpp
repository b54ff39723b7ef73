// Grounding: whether a value is accepted, marked, asked about or left aside
// (engine rule 5, filling event (4); paper IV.B "confirmation"). Pure.
#pragma once

#include "script/program/program.hpp"

namespace parlour::dialogue {

enum class Grounding : std::uint8_t {
  reject,     // as if it had not been said
  explicitly, // asked about before it is accepted
  implicitly, // accepted, and marked for the next output
  accept,
};

// Whether it is so sure that what cannot be taken back may be done: known, and
// 0.9 or more.
bool is_certain_confidence(const Value& confidence);

// `confidence`: 0..1, or unknown.
Grounding ground(script::ConfirmPolicy policy, const Value& confidence);

} // namespace parlour::dialogue
