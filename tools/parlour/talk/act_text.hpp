// What the understanding made of an utterance, as a text for people.
#pragma once

#include <string>

#include "runtime/base/value.hpp"

namespace parlour::tools {

// An act in the form of FrameInfo, such as
// "inform Taxi (0.95): Time = 15:00, Place = [A, B]"
std::string act_text(const Value& act);
// The same without confidence: "inform Taxi: Time = 15:00, Place = [A, B]"
std::string act_text_without_confidence(const Value& act);

} // namespace parlour::tools
