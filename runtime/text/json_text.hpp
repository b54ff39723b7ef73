// JSON as values, and values as JSON: what services, agents and pages send.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "runtime/base/value.hpp"

namespace parlour {

enum class JsonFault : std::uint8_t { not_json, too_deep };

// Lists and objects may be nested this deep.
inline constexpr std::size_t json_depth = 32;

// The value of one JSON text. null becomes unknown; an integer beyond 64 bits
// with a sign becomes a floating-point number, as in scripts. Of equal keys the
// last counts. Takes time linear in the text.
tl::expected<Value, JsonFault> read_json(std::string_view text);

// The value as JSON, on one line. A result of a query becomes a list of
// objects, one for each row; unknown and binary become null. Bytes that are no
// UTF-8 are replaced.
std::string json_text(const Value& value);

} // namespace parlour
