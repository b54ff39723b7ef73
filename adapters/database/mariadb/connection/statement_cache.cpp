#include "adapters/database/mariadb/connection/statement_cache.hpp"

#include <utility>

#include <mysql.h>

namespace parlour::adapters {

void PreparedStatement::Closing::operator()(st_mysql_stmt* handle) const {
  mysql_stmt_close(handle);
}

PreparedStatement* StatementCache::find(std::string_view sql) {
  const auto place = places_.find(sql);
  if (place == places_.end())
    return nullptr;
  statements_.splice(statements_.begin(), statements_, place->second);
  return &newest();
}

PreparedStatement& StatementCache::add(PreparedStatement statement) {
  statements_.push_front(std::move(statement));
  places_.emplace(newest().sql, statements_.begin());
  return newest();
}

void StatementCache::forget(const PreparedStatement& closed) {
  const auto place = places_.find(closed.sql);
  const auto entry = place->second;
  (void)entry->statement.release();
  places_.erase(place);
  statements_.erase(entry);
}

} // namespace parlour::adapters
