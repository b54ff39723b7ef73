// Values into placeholders and cells into values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

struct sqlite3_stmt;

namespace parlour::adapters {

// Binds every placeholder: a list by position, a map by name. unknown becomes
// NULL, booleans 1 and 0. An error of kind Type where numbers or names do not
// match, or a value is a list, a map or a result set.
Expected<void> bind_values(sqlite3_stmt* statement, const Value& values);

// NULL is unknown; bytes that are not UTF-8 become U+FFFD; blobs are binary.
// Returns how many bytes the text or blob has.
std::size_t append_cell(sqlite3_stmt* statement, int column, List& cells);

// Each malformed sequence replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

} // namespace parlour::adapters
