// ColumnReference: a column whose values language understanding uses as the
// vocabulary of a slot, such as "db:rr_staff.staff_name".
#pragma once

#include <cstddef>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

struct ColumnReference {
  std::string table;
  std::string column;
};

// What may be read of a column. Larger than the limits of a query: the names of
// everybody in a large building must fit. Still bounded, so that a reference to
// the wrong table, such as one of measurements, does not exhaust the memory.
inline constexpr std::size_t max_column_rows = 1'000'000;
inline constexpr std::size_t max_column_bytes = 256 << 20;

// Parses "db:table.column"; "db:" may be omitted. Both parts must be plain
// names ([A-Za-z_][A-Za-z0-9_]*): they are pasted into a statement, and nothing
// else may reach it. The error has the kind Settings.
Expected<ColumnReference> parse_column(const std::string& reference);

// The query for its distinct values in ascending order, without NULL. Every
// database understands it.
std::string select_values_of(const ColumnReference& place);

} // namespace parlour::adapters
