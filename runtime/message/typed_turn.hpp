// A user turn that was typed: the event of a recogniser that has understood
// each word. Who types may number the turns of a session; the number is part of
// the message, so whoever keeps the inputs of a session knows the last turn
// that it has taken.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/message/message.hpp"

namespace parlour {

// 0: without a number.
Message typed_turn(std::string words, std::uint64_t number = 0);
// Its number; 0 for any other message.
std::uint64_t number_of_turn(const Message& message);

} // namespace parlour
