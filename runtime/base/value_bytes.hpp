// A Value as bytes (bytes.hpp), for journals, snapshots and the protocol
// between our own processes. Each value has exactly one form: a byte for its
// type, then
//
//   0 unknown   1 false   2 true
//   3 integer   signed
//   4 number    fixed, the bits of an IEEE double, which is finite
//   5 string    text
//   6 list      count, values
//   7 map       count, for each entry a text and a value; keys are unique
//   8 result    count, column names; count, values of the cells
//   9 binary    the format as a text, block
//
// Reading what was written gives an equal value, and writing what was read
// gives the same bytes. Two kinds of values are written as unknown: numbers
// that are not finite (which language rule 2.5 excludes) and values nested
// deeper than `deepest_value`. The limit on nesting protects the stack of the
// reader.
#pragma once

#include <string>
#include <string_view>

#include "runtime/base/bytes.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

inline constexpr int deepest_value = 1024;

void write(ByteWriter& bytes, const Value& value);
Value read_value(ByteReader& bytes); // unknown if the reader failed

std::string to_bytes(const Value& value);
// The bytes must be exactly one value; else an error of kind File.
Expected<Value> value_from_bytes(std::string_view bytes);

} // namespace parlour
