// The SQL that an application's scripts run on its own database, as far as it
// stands in them, for those who can ask the database about it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "script/compiler/compiler.hpp"

namespace parlour::script::lint {

struct SqlStatement {
  std::string sql; // with ? for each value
  // Where each piece of `sql` begins in it and in the attribute's value.
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  Position start; // of the attribute's value
  // Columns that <by> compares, and where they are named.
  std::vector<std::pair<std::string, Position>> columns{};

  // The place of a byte of `sql`.
  Spot spot(std::size_t offset, std::size_t length) const;
};

// Those of other databases, and those that are computed, are left out.
std::vector<SqlStatement> sql_statements(const Compiled& compiled);

} // namespace parlour::script::lint
