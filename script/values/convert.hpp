// Between the interpreter's mutable boxes and the runtime's immutable values:
// always a copy, so that no two actors share what changes.
#pragma once

#include "runtime/base/value.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

Box to_box(Heap& heap, const Value& value);

// An error becomes a map of its fields. What is nested too deep, or is larger
// than `budget` values when copied, becomes unknown and sets `*truncated`.
Value to_value(const Box& box, std::size_t budget = 1 << 20,
               bool* truncated = nullptr);
// Takes from the budget what a copy outwards would be large; 0 is left where
// it does not suffice.
void weigh(const Box& box, std::size_t& budget);

Error to_error(const ErrorObject& error);

} // namespace parlour::script
