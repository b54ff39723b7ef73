// ValueWatch notices that a column has other values than before. It reads
// nothing itself and keeps what was read; not thread-safe.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters {

// "db:Archive.robot.name" without the name of the component: "db:robot.name".
std::string within_database(const std::string& column);

class ValueWatch {
public:
  using Values = std::vector<std::string>;
  using Read = std::function<Expected<Values>(const std::string& column)>;

  ValueWatch() = default;
  // Of columns by the names that slots and grammars have for them.
  explicit ValueWatch(const std::vector<std::string>& columns);

  bool is_idle() const {
    return columns_.empty();
  }
  // Whether a watched column belongs to one of these tables; case does not
  // count.
  bool concerns(const std::set<std::string>& tables) const;

  struct News {
    // Columns and their values now.
    std::vector<std::pair<std::string, Values>> changed;
    // Why a column that was read before cannot be read, once until it can be
    // read again. It keeps its old values.
    std::vector<Error> errors;
  };
  // Reads all columns. The first values of a column are no news,
  // unless it could not be read before.
  News look(const Read& read);

private:
  struct Column {
    std::string name;
    std::string table; // lower case
    Values values;
    bool was_read = false;
    bool failed = false;
  };
  static void look(Column& column, const Read& read, News& news);

  std::vector<Column> columns_;
};

// The event of the role Database that tells of new values; it belongs to no
// session.
Message values_changed(const std::string& column,
                       const ValueWatch::Values& values);

} // namespace parlour::adapters
