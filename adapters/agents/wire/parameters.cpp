#include "adapters/agents/wire/parameters.hpp"

#include <algorithm>

#include "runtime/text/json_text.hpp"

namespace parlour::adapters::agents {
namespace {

// The beginning of a JSON parameter.
constexpr std::string_view mark = "\x01J";

// Values that only JSON can represent.
bool is_compound(const Value& value) {
  return value.if_list() || value.if_map() || value.if_result();
}

} // namespace

std::string parameter_of(const Value& value, bool json) {
  // A text that begins like the mark must be sent as JSON, or it would be read
  // as such.
  if (const auto* text = value.if_string())
    if (!json || !text->starts_with('\x01'))
      return *text;
  if (json)
    return std::string(mark) + json_text(value);
  if (is_compound(value))
    return json_text(value);
  return value.is_unknown() || value.if_binary() ? "" : value.text();
}

Read<Value> value_of(std::string_view parameter, bool json) {
  if (!json || !parameter.starts_with(mark))
    return Value(parameter);
  auto read = read_json(parameter.substr(mark.size()));
  if (!read && read.error() == JsonFault::too_deep)
    return malformed("a JSON parameter is nested too deep");
  if (!read)
    return malformed("what follows the mark of a JSON parameter is no JSON");
  return std::move(*read);
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
