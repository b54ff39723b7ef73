#include "adapters/http/rules/json_path.hpp"

#include <algorithm>
#include <charconv>

namespace parlour::adapters::http {

namespace {

constexpr std::string_view each = "*";

// "~1" is "/", "~0" is "~".
std::string decoded(std::string_view step) {
  std::string key;
  for (std::size_t i = 0; i < step.size(); ++i)
    if (step[i] == '~' && i + 1 < step.size() &&
        (step[i + 1] == '0' || step[i + 1] == '1'))
      key += step[++i] == '0' ? '~' : '/';
    else
      key += step[i];
  return key;
}

// The element of a list or the entry of a map; null if there is none.
const Value* child(const Value& value, const std::string& step) {
  if (const auto* map = value.if_map())
    return map->find(decoded(step));
  const auto* list = value.if_list();
  std::size_t position = 0;
  const auto* const end = step.data() + step.size();
  const auto read = std::from_chars(step.data(), end, position);
  if (!list || read.ec != std::errc() || read.ptr != end ||
      position >= list->size())
    return nullptr;
  return &(*list)[position];
}

// The entries of a map in its own order, as "*" means all of them.
std::vector<Value> children(const Value& value) {
  if (const auto* list = value.if_list())
    return *list;
  std::vector<Value> entries;
  if (const auto* map = value.if_map())
    for (const auto& [key, entry] : map->entries())
      entries.push_back(entry);
  return entries;
}

} // namespace

// "/days/0/" has a last step that is empty: the entry with the empty name.
JsonPath::JsonPath(std::string_view text) : text_(text) {
  for (std::size_t at = 1; text.size() > 1 && at <= text.size();) {
    const auto end = std::min(text.find('/', at), text.size());
    steps_.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
}

std::optional<Value> JsonPath::find(const Value& value) const {
  return find(value, 0);
}

std::optional<Value> JsonPath::find(const Value& value,
                                    std::size_t step) const {
  if (step == steps_.size())
    return value;
  if (steps_[step] == each)
    return find_all(value, step + 1);
  const auto* const next = child(value, steps_[step]);
  return next ? find(*next, step + 1) : std::nullopt;
}

// A second "*" adds to the same list. Elements without the rest of the path are
// left out.
std::optional<Value> JsonPath::find_all(const Value& value,
                                        std::size_t step) const {
  if (!value.if_list() && !value.if_map())
    return std::nullopt;
  const bool is_last =
      std::find(steps_.begin() + static_cast<std::ptrdiff_t>(step),
                steps_.end(), each) == steps_.end();
  List found;
  for (const auto& one : children(value)) {
    const auto rest = find(one, step);
    if (!rest)
      continue;
    if (is_last)
      found.push_back(*rest);
    else
      found.insert(found.end(), rest->if_list()->begin(),
                   rest->if_list()->end());
  }
  return Value(std::move(found));
}

} // namespace parlour::adapters::http
