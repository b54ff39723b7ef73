#include "script/support/footprint.hpp"

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
  switch (value.type()) {
  case ValueType::string:
    return own + value.if_string()->size();
  case ValueType::list:
    return own + footprint(*value.if_list());
  case ValueType::map:
    return own + footprint(*value.if_map());
  case ValueType::result:
    return own + footprint(*value.if_result());
  case ValueType::binary:
    return own + value.if_binary()->bytes.size();
  default:
    return own;
  }
}

} // namespace parlour::script
