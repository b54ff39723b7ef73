#include "script/footprint.hpp"

namespace parlour::script {

namespace {

std::size_t footprint(const List& values) {
  std::size_t bytes = 0;
  for (const auto& value : values)
    bytes += script::footprint(value);
  return bytes;
}

std::size_t footprint(const ResultSet& result) {
  auto bytes = footprint(result.cells);
  for (const auto& column : result.columns)
    bytes += sizeof(column) + column.size();
  return bytes;
}

std::size_t footprint(const Map& map) {
  std::size_t bytes = 0;
  for (const auto& [key, value] : map.entries())
    bytes += sizeof(key) + key.size() + script::footprint(value);
  return bytes;
}

} // namespace

std::size_t footprint(const Value& value) {
  constexpr auto own = sizeof(Value);
  if (const auto* string = value.if_string())
    return own + string->size();
  if (const auto* list = value.if_list())
    return own + footprint(*list);
  if (const auto* map = value.if_map())
    return own + footprint(*map);
  if (const auto* result = value.if_result())
    return own + footprint(*result);
  if (const auto* binary = value.if_binary())
    return own + binary->bytes.size();
  return own;
}

} // namespace parlour::script
