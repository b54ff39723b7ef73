// What a recogniser may have heard: it fires other texts beside the likeliest
// one, and the understanding may find that another makes more sense. Pure.
#pragma once

#include "runtime/base/value.hpp"
#include "runtime/message/message.hpp"

namespace parlour::dialogue {

// The texts of a RecognitionResult, the likeliest first; unknown where nothing
// was heard, but typed.
Value heard_texts(const Message& result);

// The context of the understanding of `text`, with what else was heard:
// nothing, if it is not the likeliest of the texts `heard`.
Value with_heard(Value context, const Value& text, const Value& heard);

} // namespace parlour::dialogue
