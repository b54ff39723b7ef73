#include "adapters/nlu/values/known_columns.hpp"

#include <utility>

namespace parlour::adapters::nlu {

Expected<std::vector<std::string>>
KnownColumns::read(const std::string& name, const ColumnReader& read) {
  if (const auto found = columns_.find(name); found != columns_.end())
    return found->second;
  auto values = read(name);
  if (values)
    columns_.emplace(name, *values);
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
