// Converts values of scripts to SQLite's placeholders, and SQLite's cells to
// values.
#pragma once

#include <cstddef>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

struct sqlite3_stmt;

namespace parlour::adapters {

// Binds every placeholder of a statement: a list by position, a map by name.
// unknown becomes NULL, booleans become 1 and 0. `values` must stay unchanged
// until the statement is reset. The error is Type if numbers or names do not
// match or a value is a list, a map or a result set, and Limit if a value is
// too long.
Expected<void> bind_values(sqlite3_stmt* statement, const Value& values);

// Appends the cells of the current row and returns how many bytes they hold.
// NULL becomes unknown, blobs become binary values, and bytes that are not
// UTF-8 become U+FFFD.
std::size_t append_row(sqlite3_stmt* statement, std::size_t columns,
                       List& cells);

} // namespace parlour::adapters
