// Values into placeholders and cells into values, as SQLite's columns hold
// them: so that a script finds the same in both.
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

// In the order of the placeholders: a list by position, a map by name. An
// error of kind Type where numbers or names do not match, or a value cannot
// stand in a table.
Expected<List> values_in_order(const Value& values,
                               const std::vector<std::string>& names);

// The values of a statement's placeholders, one execution after the other, at
// places that stay: the server is told their types where they change. unknown
// becomes NULL, booleans 1 and 0.
class MariaDBParameters {
public:
  MariaDBParameters();
  MariaDBParameters(MariaDBParameters&&) noexcept;
  MariaDBParameters& operator=(MariaDBParameters&&) noexcept;
  ~MariaDBParameters();

  // Those of the next execution, copied; fails as values_in_order does.
  Expected<void> take(const Value& values,
                      const std::vector<std::string>& names);
  bool bind(st_mysql_stmt* statement);
  // Whether they have grown so far that they are not worth keeping.
  bool are_large() const;

private:
  struct Place;

  std::vector<Place> places_;
  std::vector<st_mysql_bind> binds_;
  bool is_bound_ = false; // as the places are
};

// Where the cells of a row arrive. NULL is unknown, a decimal a number; dates
// and times are texts; bytes that are not UTF-8 become U+FFFD; blobs are
// binary.
class MariaDBRow {
public:
  explicit MariaDBRow(st_mysql_res* description);
  MariaDBRow(const MariaDBRow&) = delete;
  MariaDBRow& operator=(const MariaDBRow&) = delete;
  ~MariaDBRow();

  const Columns& columns() const {
    return columns_;
  }
  // Whether rows of that description can arrive here.
  bool fits(st_mysql_res* description) const;
  // Whether it has grown so far that it is not worth keeping.
  bool is_large() const;
  bool bind(st_mysql_stmt* statement);
  // How many bytes the fetched row holds; they need not be in memory yet.
  std::size_t size() const;
  void append_to(List& cells, st_mysql_stmt* statement);

private:
  struct Cell;

  Columns columns_;
  std::vector<Cell> cells_;
  std::vector<st_mysql_bind> binds_;
};

} // namespace parlour::adapters
