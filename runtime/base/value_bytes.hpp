// A Value as bytes (bytes.hpp), for journals, snapshots and the wire between
// our own processes. Each value has one form: a byte for its type, then
//
//   0 unknown   1 false   2 true
//   3 integer   signed
//   4 number    fixed, the bits of an IEEE double, finite
//   5 string    text
//   6 list      count, values
//   7 map       count, each a text and a value; no key twice
//   8 result    count, column names; count, values of its cells
//   9 binary    text of its format, block
//
// Reading what was written gives the same value; writing what was read, the
// same bytes. A number that is not finite, which language rule 2.5 says never
// arises, and what is nested deeper than `deepest_value` are written as
// unknown.
#pragma once

#include <string>
#include <string_view>

#include "runtime/base/bytes.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

inline constexpr int deepest_value = 1024;

void write(ByteWriter& bytes, const Value& value);
Value read_value(ByteReader& bytes); // unknown where the reader failed

std::string to_bytes(const Value& value);
// An error of kind File where they are not the bytes of one value.
Expected<Value> value_from_bytes(std::string_view bytes);

} // namespace parlour
