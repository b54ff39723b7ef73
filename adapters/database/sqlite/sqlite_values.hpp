// Values into placeholders and cells into values.
#pragma once

#include <cstddef>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

struct sqlite3_stmt;

namespace parlour::adapters {

// Binds every placeholder: a list by position, a map by name. unknown becomes
// NULL, booleans 1 and 0. An error of kind Type where numbers or names do not
// match, or a value is a list, a map or a result set.
Expected<void> bind_values(sqlite3_stmt* statement, const Value& values);

// NULL is unknown; bytes that are not UTF-8 become U+FFFD; blobs are binary.
// Returns how many bytes the row holds.
std::size_t append_row(sqlite3_stmt* statement, std::size_t columns,
                       List& cells);

} // namespace parlour::adapters
