#include "adapters/agents/wire/parameters.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace parlour::adapters::agents {
namespace {

using Json = nlohmann::ordered_json;

// The beginning of a JSON parameter, and the deepest nesting that is read: the
// conversion to values is recursive.
constexpr std::string_view mark = "\x01J";
constexpr int max_depth = 32;

// -- writing ------------------------------------------------------------------

Json json_of(const Value& value);

// A result of a query becomes a list of maps, one for each row.
Json json_of(const ResultSet& result) {
  auto rows = Json::array();
  for (std::size_t row = 0; row < result.row_count(); ++row) {
    auto cells = Json::object();
    for (const auto& column : result.columns)
      cells[column] = json_of(*result.cell(row, column));
    rows.push_back(std::move(cells));
  }
  return rows;
}

Json json_of(const Value& value) {
  switch (value.type()) {
  case ValueType::unknown:
  case ValueType::binary:
    return nullptr;
  case ValueType::boolean:
    return *value.if_boolean();
  case ValueType::integer:
    return *value.if_integer();
  case ValueType::number:
    return *value.if_number();
  case ValueType::string:
    return *value.if_string();
  case ValueType::result:
    return json_of(*value.if_result());
  case ValueType::list: {
    auto list = Json::array();
    for (const auto& element : *value.if_list())
      list.push_back(json_of(element));
    return list;
  }
  case ValueType::map: {
    auto map = Json::object();
    for (const auto& [key, entry] : value.if_map()->entries())
      map[key] = json_of(entry);
    return map;
  }
  }
  return nullptr;
}

// Values that only JSON can represent.
bool is_compound(const Value& value) {
  return value.if_list() || value.if_map() || value.if_result();
}

// -- reading ------------------------------------------------------------------

// Integers beyond the signed range become floating-point numbers, as in
// scripts.
Value value_of_json(const Json& json) {
  if (json.is_boolean())
    return json.get<bool>();
  if (json.is_number_integer() &&
      !(json.is_number_unsigned() &&
        json.get<std::uint64_t>() > std::uint64_t{INT64_MAX}))
    return json.get<std::int64_t>();
  if (json.is_number())
    return json.get<double>();
  if (json.is_string())
    return json.get<std::string>();
  if (json.is_array()) {
    List list;
    for (const auto& element : json)
      list.push_back(value_of_json(element));
    return list;
  }
  Map map;
  if (json.is_object())
    for (const auto& [key, entry] : json.items())
      map.set(key, value_of_json(entry));
  return json.is_object() ? Value(std::move(map)) : Value();
}

// Bounds the depth of nesting: the parser calls `watch` for each value that
// begins.
Read<Json> parse(std::string_view text) {
  bool too_deep = false;
  const auto watch = [&](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > max_depth;
    return !too_deep;
  };
  auto json = Json::parse(text, watch, false);
  if (too_deep)
    return malformed("a JSON parameter is nested too deep");
  if (json.is_discarded())
    return malformed("what follows the mark of a JSON parameter is no JSON");
  return json;
}

} // namespace

std::string parameter_of(const Value& value, bool json) {
  // A text that begins like the mark must be sent as JSON, or it would be read
  // as such.
  if (const auto* text = value.if_string())
    if (!json || !text->starts_with('\x01'))
      return *text;
  if (json)
    return std::string(mark) +
           json_of(value).dump(-1, ' ', false, Json::error_handler_t::replace);
  if (is_compound(value))
    return json_of(value).dump(-1, ' ', false, Json::error_handler_t::replace);
  return value.is_unknown() || value.if_binary() ? "" : value.text();
}

Read<Value> value_of(std::string_view parameter, bool json) {
  if (!json || !parameter.starts_with(mark))
    return Value(parameter);
  auto parsed = parse(parameter.substr(mark.size()));
  if (!parsed)
    return tl::make_unexpected(std::move(parsed.error()));
  return value_of_json(*parsed);
}

Read<AgentMessage> message_for_agent(const Message& message, bool json,
                                     std::optional<Milliseconds> deadline) {
  AgentMessage made;
  made.session = message.session;
  made.sinks = message.sinks;
  // A time before 1970 cannot be written.
  made.time =
      static_cast<std::uint64_t>(std::max<std::int64_t>(message.time, 0));
  if (message.correlation != 0)
    made.correlation = message.correlation;
  if (deadline)
    made.deadline = static_cast<std::uint64_t>(
        std::max<std::int64_t>(deadline->count(), 0));
  made.component = message.source;
  made.command = message.command;
  for (std::size_t i = 0; i < message.params.size(); ++i) {
    const auto* binary = message.params[i].if_binary();
    if (!binary) {
      made.parameters.push_back(parameter_of(message.params[i], json));
      continue;
    }
    if (made.payload)
      return malformed("a message for an agent has at most one payload");
    made.kind = MessageKind::binary;
    made.payload.emplace();
    made.payload->format = binary->format;
    made.payload->bytes.assign(
        reinterpret_cast<const char*>(binary->bytes.data()),
        binary->bytes.size());
    // The last position is the default.
    if (i + 1 < message.params.size())
      made.payload->position = i;
  }
  return made;
}

Read<Message> message_from_agent(const AgentMessage& message, bool json) {
  Message made;
  made.source = message.component;
  made.command = message.command;
  made.session = message.session;
  made.sinks = message.sinks;
  made.correlation = message.correlation.value_or(0);
  for (const auto& parameter : message.parameters) {
    auto value = value_of(parameter, json);
    if (!value)
      return tl::make_unexpected(std::move(value.error()));
    made.params.push_back(std::move(*value));
  }
  if (!message.payload)
    return made;
  const auto& bytes = message.payload->bytes;
  const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
  // The position was checked against the parameters when the message was read.
  const auto position = std::min<std::uint64_t>(
      message.payload->position.value_or(made.params.size()),
      made.params.size());
  made.params.insert(
      made.params.begin() + static_cast<std::ptrdiff_t>(position),
      Binary{message.payload->format, {first, first + bytes.size()}});
  return made;
}

} // namespace parlour::adapters::agents
