// Writing and reading of values, with the same structure on both sides: a
// function for each kind of container, one dispatch by type or tag, and a depth
// that is counted on the way down.

#include "runtime/base/value_bytes.hpp"

#include <bit>
#include <cmath>
#include <cstring>

namespace parlour {

namespace {

// The numbers are part of the format: append only.
enum class Tag : std::uint8_t {
  unknown,
  no,
  yes,
  integer,
  number,
  string,
  list,
  map,
  result,
  binary,
};

void put(ByteWriter& bytes, Tag tag) {
  bytes.byte(static_cast<std::uint8_t>(tag));
}

void write(ByteWriter& bytes, const Value& value, int depth);

void write_all(ByteWriter& bytes, const List& values, int depth) {
  bytes.number(values.size());
  for (const auto& value : values)
    write(bytes, value, depth + 1);
}

void write(ByteWriter& bytes, const Map& map, int depth) {
  put(bytes, Tag::map);
  bytes.number(map.size());
  for (const auto& [key, value] : map.entries()) {
    bytes.text(key);
    write(bytes, value, depth + 1);
  }
}

void write(ByteWriter& bytes, const ResultSet& result, int depth) {
  put(bytes, Tag::result);
  bytes.number(result.columns.size());
  for (const auto& column : result.columns)
    bytes.text(column);
  write_all(bytes, result.cells, depth);
}

void write(ByteWriter& bytes, const Binary& binary) {
  put(bytes, Tag::binary);
  bytes.text(binary.format);
  bytes.text({reinterpret_cast<const char*>(binary.bytes.data()),
              binary.bytes.size()});
}

void write_number(ByteWriter& bytes, double number) {
  if (!std::isfinite(number))
    return put(bytes, Tag::unknown);
  put(bytes, Tag::number);
  bytes.fixed(std::bit_cast<std::uint64_t>(number));
}

// Values that are nested too deep become unknown instead of an error: a value
// that exists can always be written.
void write(ByteWriter& bytes, const Value& value, int depth) {
  if (depth > deepest_value)
    return put(bytes, Tag::unknown);
  switch (value.type()) {
  case ValueType::unknown:
    return put(bytes, Tag::unknown);
  case ValueType::boolean:
    return put(bytes, *value.if_boolean() ? Tag::yes : Tag::no);
  case ValueType::integer:
    put(bytes, Tag::integer);
    return bytes.signed_number(*value.if_integer());
  case ValueType::number:
    return write_number(bytes, *value.if_number());
  case ValueType::string:
    put(bytes, Tag::string);
    return bytes.text(*value.if_string());
  case ValueType::list:
    put(bytes, Tag::list);
    return write_all(bytes, *value.if_list(), depth);
  case ValueType::map:
    return write(bytes, *value.if_map(), depth);
  case ValueType::result:
    return write(bytes, *value.if_result(), depth);
  case ValueType::binary:
    return write(bytes, *value.if_binary());
  }
}

Value read(ByteReader& bytes, int depth);

List read_all(ByteReader& bytes, const char* what, int depth) {
  // Nothing is reserved: each of many nested lists could claim as many elements
  // as there are bytes left.
  List values;
  const auto count = bytes.count(what);
  for (std::size_t i = 0; i < count && bytes.ok(); ++i)
    values.push_back(read(bytes, depth + 1));
  return values;
}

Value read_map(ByteReader& bytes, int depth) {
  Map map;
  const auto count = bytes.count("entries of a map");
  for (std::size_t i = 0; i < count && bytes.ok(); ++i) {
    const auto key = bytes.text();
    map.set(key, read(bytes, depth + 1));
    // A repeated key would not add an entry. It is rejected because a value has
    // one form only.
    if (map.size() != i + 1)
      bytes.fail("a map has the key '" + std::string(key) + "' twice");
  }
  return map;
}

Value read_result(ByteReader& bytes, int depth) {
  std::vector<std::string> columns;
  const auto count = bytes.count("columns");
  for (std::size_t i = 0; i < count && bytes.ok(); ++i)
    columns.emplace_back(bytes.text());
  return ResultSet{std::move(columns), read_all(bytes, "cells", depth)};
}

Value read_binary(ByteReader& bytes) {
  Binary binary;
  binary.format = bytes.text();
  const auto block = bytes.block();
  binary.bytes.resize(block.size());
  if (!block.empty())
    std::memcpy(binary.bytes.data(), block.data(), block.size());
  return binary;
}

// Infinities and NaN are never written, so they mean corrupt bytes.
Value read_number(ByteReader& bytes) {
  const auto number = std::bit_cast<double>(bytes.fixed());
  if (!std::isfinite(number))
    bytes.fail("a number is not finite");
  return number;
}

// The tag has been read. An unknown tag is a failure.
Value read_tagged(ByteReader& bytes, Tag tag, int depth) {
  switch (tag) {
  case Tag::unknown:
    return {};
  case Tag::no:
    return false;
  case Tag::yes:
    return true;
  case Tag::integer:
    return bytes.signed_number();
  case Tag::number:
    return read_number(bytes);
  case Tag::string:
    return bytes.text();
  case Tag::list:
    return read_all(bytes, "elements of a list", depth);
  case Tag::map:
    return read_map(bytes, depth);
  case Tag::result:
    return read_result(bytes, depth);
  case Tag::binary:
    return read_binary(bytes);
  }
  bytes.fail("there is no type of value " +
             std::to_string(static_cast<int>(tag)));
  return {};
}

// After a failure every value is unknown, so callers need to check only once.
Value read(ByteReader& bytes, int depth) {
  const auto tag = static_cast<Tag>(bytes.byte());
  if (depth > deepest_value && tag != Tag::unknown)
    bytes.fail("a value is nested more than " + std::to_string(deepest_value) +
               " deep");
  if (!bytes.ok())
    return {};
  auto value = read_tagged(bytes, tag, depth);
  return bytes.ok() ? value : Value();
}

} // namespace

void write(ByteWriter& bytes, const Value& value) {
  write(bytes, value, 0);
}

Value read_value(ByteReader& bytes) {
  return read(bytes, 0);
}

std::string to_bytes(const Value& value) {
  ByteWriter bytes;
  write(bytes, value);
  return bytes.take();
}

Expected<Value> value_from_bytes(std::string_view bytes) {
  ByteReader reader(bytes);
  auto value = read_value(reader);
  if (reader.ok() && !reader.at_end())
    reader.fail("more bytes follow the value");
  if (!reader.ok())
    return tl::make_unexpected(reader.error());
  return value;
}

} // namespace parlour
