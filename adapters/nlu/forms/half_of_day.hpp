// The half of the day that a time is meant in: said behind it ("three in the
// afternoon"), or anywhere in its sentence ("tonight at eight").
#pragma once

#include "adapters/nlu/forms/form_reader.hpp"

namespace parlour::adapters::nlu {

enum class Half { unknown, am, pm, night };

// Reads "am", "pm", "in the morning", "this evening", "at night" … and advances
// past it.
Half skip_half(FormReader& reader);

// What the reader's sentence says beside the time: "tomorrow morning at half
// seven". Unknown if it says nothing, or two different things, or says it of
// another time ("from nine in the morning to five").
Half half_of_sentence(const FormReader& reader);

// The hour of 24 that an hour of 12 is; an hour beyond 12 stays. "at night"
// means evening from 6 to 11 and morning otherwise. `half` is known.
std::int64_t hour_in_half(std::int64_t hour, Half half);

} // namespace parlour::adapters::nlu
