// KnownColumns: the values of columns as they were read or told last, so that
// an understanding can be built anew from them without asking the database.
#pragma once

#include <map>
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
  // False if the column was never read, or has these values already.
  bool set(const std::string& name, const List& values);

private:
  std::map<std::string, std::vector<std::string>> columns_;
};

} // namespace parlour::adapters::nlu
