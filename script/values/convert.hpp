// Conversion between the interpreter's mutable boxes and the runtime's
// immutable values. Lists, maps and strings are always copied, so that actors
// never share anything that changes.
//
//   Box (script, mutable)          Value (runtime, immutable)
//   list, map, string     <-->     copied
//   integer of 48 or 64 bits <-->  integer
//   result, binary        <-->     shared
//   error                  -->     a map with its fields
#pragma once

#include "runtime/base/value.hpp"
#include "script/values/objects.hpp"
#include "script/values/walk_budget.hpp"

namespace parlour::script {

// Result sets and binaries are immutable and are shared, not copied.
Box to_box(Heap& heap, const Value& value);
// The same; texts that are constants of the program are shared, too.
Box to_box(Heap& heap, const Value& value, const ConstantPool& constants);

// Copies a value out of the interpreter. An error becomes a map of its fields.
// Parts that are nested too deep, or for which the budget does not suffice,
// become unknown, and the budget is exhausted.
Value to_value(const Box& box, WalkBudget& budget);
// The same with a budget that suffices for all but monstrous values.
Value to_value(const Box& box);
// Takes from the budget what a copy by to_value would.
void measure(const Box& box, WalkBudget& budget);

Error to_error(const ErrorObject& error);

} // namespace parlour::script
