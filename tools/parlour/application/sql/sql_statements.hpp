// The SQL statements of an application on its own database, as far as they are
// written out in its scripts. `parlour check` lets the database check them.
//
// "select * from staff where name = {who}" becomes "select * from staff where
// name = ?".
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "script/compiler/compiler.hpp"

namespace parlour::tools {

// A statement, and how to find the place of each of its bytes in the script.
struct SqlStatement {
  std::string sql; // with ? for each value
  // Where each literal piece begins, in `sql` and in the attribute's value.
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  script::Position start; // of the attribute's value
  // The columns that <by> elements compare, and where they are named.
  std::vector<std::pair<std::string, script::Position>> columns{};

  // The place of a byte of `sql`, for a finding.
  script::Spot spot(std::size_t offset, std::size_t length) const;
};

// Statements for other databases and computed ones are left out.
std::vector<SqlStatement> sql_statements(const script::Compiled& compiled);

} // namespace parlour::tools
