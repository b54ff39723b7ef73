// StatementCache keeps the prepared statements of a connection by their SQL.
// It talks to no server: who makes room closes the statement there.
#pragma once

#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "adapters/database/mariadb/connection/mariadb_dialect.hpp"
#include "adapters/database/mariadb/connection/mariadb_values.hpp"

struct st_mysql_stmt;

namespace parlour::adapters {

struct PreparedStatement {
  struct Closing {
    void operator()(st_mysql_stmt* statement) const;
  };

  std::string sql;
  // The names of its placeholders, "" for `?`.
  std::vector<std::string> names;
  StatementKind kind;
  std::unique_ptr<st_mysql_stmt, Closing> statement;
  MariaDBParameters parameters = {};
  // The buffers of the last result, kept for the next execution.
  std::unique_ptr<MariaDBRow> row = nullptr;
};

// Not thread-safe. Statements that are left are closed by the destructor, which
// waits for the server unless their connection is closed already.
class StatementCache {
public:
  // Null if it is not there. It becomes the newest one.
  PreparedStatement* find(std::string_view sql);
  // Adds it as the newest one. No other has its SQL.
  PreparedStatement& add(PreparedStatement statement);

  std::size_t size() const {
    return statements_.size();
  }
  // That was used last, or longest ago. There is one.
  PreparedStatement& newest() {
    return statements_.front();
  }
  PreparedStatement& oldest() {
    return statements_.back();
  }
  // Forgets a statement that is closed.
  void forget(const PreparedStatement& closed);

private:
  using Statements = std::list<PreparedStatement>;

  Statements statements_; // the newest is the first
  // Where each is, by its SQL; the keys point into the statements.
  std::unordered_map<std::string_view, Statements::iterator> places_;
};

} // namespace parlour::adapters
