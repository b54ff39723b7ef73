// Converts values of scripts to MariaDB's placeholders and MariaDB's cells to
// values. A script finds the same types as with SQLite.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

struct st_mysql_bind;
struct st_mysql_stmt;
struct st_mysql_res;

namespace parlour::adapters {

// Arranges values in the order of the placeholders: a list by position, a map
// by name. The error is Type if numbers or names do not match, or if a value is
// a list, a map or a result set.
Expected<List> values_in_order(const Value& values,
                               const std::vector<std::string>& names);

// The values of a prepared statement's placeholders. The buffers keep their
// addresses from one execution to the next, so that the server is told the
// types again only when they change. unknown becomes NULL, booleans become 1
// and 0.
class MariaDBParameters {
public:
  MariaDBParameters();
  MariaDBParameters(MariaDBParameters&&) noexcept;
  MariaDBParameters& operator=(MariaDBParameters&&) noexcept;
  ~MariaDBParameters();

  // Copies the values of the next execution. Fails as values_in_order does.
  Expected<void> take(const Value& values,
                      const std::vector<std::string>& names);
  // Tells the library where the values are. False if it refuses.
  bool bind(st_mysql_stmt* statement);
  // Whether the buffers have grown so large that they should not be kept.
  bool are_large() const;

private:
  struct Parameter;

  std::vector<Parameter> parameters_;
  std::vector<st_mysql_bind> binds_;
  // Whether the library knows the current addresses and types.
  bool is_bound_ = false;
};

// The buffers into which the library writes the cells of one row. NULL becomes
// unknown, a decimal a number, dates and times become texts, blobs become
// binary values, and bytes that are not UTF-8 become U+FFFD.
class MariaDBRow {
public:
  // Buffers for the columns that the description of a result lists.
  explicit MariaDBRow(st_mysql_res* description);
  MariaDBRow(const MariaDBRow&) = delete;
  MariaDBRow& operator=(const MariaDBRow&) = delete;
  ~MariaDBRow();

  const Columns& columns() const {
    return columns_;
  }
  // Whether rows of this description fit the buffers.
  bool fits(st_mysql_res* description) const;
  // Whether a buffer has grown so large that it should not be kept.
  bool is_large() const;
  bool bind(st_mysql_stmt* statement);
  // The bytes of the fetched row, some of which may still be at the server: the
  // limit can be checked before they are fetched.
  std::size_t size() const;
  // Appends the cells as values. Fetches those that were too long for their
  // buffer, which grows. False if the library refuses.
  bool append_to(List& cells, st_mysql_stmt* statement);

private:
  struct Cell;

  Columns columns_;
  std::vector<Cell> cells_;
  std::vector<st_mysql_bind> binds_;
};

} // namespace parlour::adapters
