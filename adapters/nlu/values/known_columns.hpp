// KnownColumns: the values of columns as they were read or told last, so that
// an understanding can be built anew from them without asking the database.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/value.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

// Not thread-safe.
class KnownColumns {
public:
  // Reads a column once, by `read`; a failure is told and not kept.
  Expected<std::vector<std::string>> read(const std::string& name,
                                          const ColumnReader& read);
  // False if nobody has asked for the column, or it has these values already.
  bool set(const std::string& name, const List& values);

private:
  // Nothing: it could not be read.
  std::map<std::string, std::optional<std::vector<std::string>>> columns_;
};

} // namespace parlour::adapters::nlu
