#include "adapters/nlu/values/known_columns.hpp"

#include <utility>

namespace parlour::adapters::nlu {

Expected<std::vector<std::string>>
KnownColumns::read(const std::string& name, const ColumnReader& read) {
  auto& known = columns_[name];
  if (known)
    return *known;
  auto values = read(name);
  if (values)
    known = *values;
  return values;
}

bool KnownColumns::set(const std::string& name, const List& values) {
  const auto found = columns_.find(name);
  if (found == columns_.end())
    return false;
  std::vector<std::string> texts;
  for (const auto& value : values)
    texts.push_back(value.text());
  return std::exchange(found->second, texts) != texts;
}

} // namespace parlour::adapters::nlu
