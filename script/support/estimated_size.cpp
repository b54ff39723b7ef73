#include "script/support/estimated_size.hpp"

namespace parlour::script {

namespace {

std::size_t estimated_size(const List& values) {
  std::size_t bytes = 0;
  for (const auto& value : values)
    bytes += script::estimated_size(value);
  return bytes;
}

std::size_t estimated_size(const ResultSet& result) {
  auto bytes = estimated_size(result.cells);
  for (const auto& column : result.columns)
    bytes += sizeof(column) + column.size();
  return bytes;
}

std::size_t estimated_size(const Map& map) {
  std::size_t bytes = 0;
  for (const auto& [key, value] : map.entries())
    bytes += sizeof(key) + key.size() + script::estimated_size(value);
  return bytes;
}

} // namespace

// Counts what grows with the content; the overhead of the allocator is left
// out.
std::size_t estimated_size(const Value& value) {
  constexpr auto own = sizeof(Value);
  switch (value.type()) {
  case ValueType::string:
    return own + value.if_string()->size();
  case ValueType::list:
    return own + estimated_size(*value.if_list());
  case ValueType::map:
    return own + estimated_size(*value.if_map());
  case ValueType::result:
    return own + estimated_size(*value.if_result());
  case ValueType::binary:
    return own + value.if_binary()->bytes.size();
  default:
    return own;
  }
}

} // namespace parlour::script
