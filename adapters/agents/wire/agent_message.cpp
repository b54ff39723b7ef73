// Reading and writing of the first field (kind and attributes), and of the
// fields as a whole. Attributes whose value is a number are one table, used in
// both directions.
#include "adapters/agents/wire/agent_message.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

namespace parlour::adapters::agents {
namespace {

constexpr std::array kind_names = {
#define X(name, sentence) std::string_view(#name),
#include "adapters/agents/wire/message_kinds.def"
#undef X
};

// The position of the first parameter among the fields, and the first number
// that is too large.
constexpr std::size_t first_parameter = 4;
constexpr std::uint64_t end_of_numbers = std::uint64_t{1} << 63;

// An attribute whose value is a number.
struct NumberAttribute {
  char letter;
  std::optional<std::uint64_t> AgentMessage::*member;
};

constexpr std::array number_attributes = {
    NumberAttribute{'n', &AgentMessage::number},
    NumberAttribute{'a', &AgentMessage::acknowledged},
    NumberAttribute{'w', &AgentMessage::window},
    NumberAttribute{'c', &AgentMessage::correlation},
    NumberAttribute{'d', &AgentMessage::deadline},
};

// The characters that a value of an attribute may have.
bool is_attribute_text(std::string_view value) {
  return !value.empty() && std::ranges::all_of(value, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' ||
           c == ':';
  });
}

// A number as the protocol writes it (adapters/agents/PROTOCOL.md 1.3), or
// nothing.
std::optional<std::uint64_t> number_of(std::string_view text) {
  std::uint64_t number = 0;
  const auto* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc() || stop != end ||
      number >= end_of_numbers)
    return {};
  return number;
}

// Nothing for a kind of a later version.
std::optional<MessageKind> kind_of(std::string_view name) {
  const auto found = std::ranges::find(kind_names, name);
  if (found == kind_names.end())
    return {};
  return static_cast<MessageKind>(found - kind_names.begin());
}

// -- reading ------------------------------------------------------------------

std::string described(char letter, std::string_view value) {
  return fmt::format("the attribute {}={}", letter, excerpt(value));
}

// Reads attributes one after the other into a message. `seen_` holds the
// letters so far: only `k` may occur more than once.
class AttributeReader {
public:
  explicit AttributeReader(AgentMessage& message) : message_(message) {}

  // `part` stands between two semicolons: "n=12".
  Read<void> take(std::string_view part) {
    if (part.size() < 2 || part[1] != '=')
      return malformed("an attribute is written letter=value, not '" +
                       excerpt(part) + "'");
    const auto letter = part[0];
    const auto value = part.substr(2);
    if (!is_attribute_text(value))
      return malformed(described(letter, value) +
                       " holds what an attribute cannot hold");
    if (letter == 'k') {
      message_.sinks.emplace_back(value);
      return {};
    }
    if (seen_.find(letter) != std::string::npos)
      return malformed(described(letter, value) + " occurs twice");
    seen_ += letter; // rarely more than fit into the string itself
    return set(letter, value);
  }

private:
  Read<void> set(char letter, std::string_view value) {
    if (letter == 's') {
      message_.session = value;
      return {};
    }
    if (letter == 'g') {
      message_.gap = value == "1";
      return {};
    }
    for (const auto& attribute : number_attributes)
      if (attribute.letter == letter)
        return set_number(message_.*attribute.member, letter, value);
    if (letter == 'p') {
      message_.payload.emplace();
      return set_number(message_.payload->position, letter, value);
    }
    // Attributes of later versions are ignored.
    return {};
  }

  static Read<void> set_number(std::optional<std::uint64_t>& target,
                               char letter, std::string_view value) {
    target = number_of(value);
    if (!target)
      return malformed(described(letter, value) + " is no number");
    return {};
  }

  AgentMessage& message_;
  std::string seen_;
};

// The limits of 1.6 but that of the head, at reading and at writing. `more` are
// bytes of the payload that are not in the message yet.
Read<void> check_size(const AgentMessage& message, std::size_t more = 0) {
  if (message.parameters.size() > max_parameters)
    return oversized("a message has at most " + std::to_string(max_parameters) +
                     " parameters");
  if (content_bytes(message) + more > max_message_bytes)
    return oversized("a message has at most " +
                     std::to_string(max_message_bytes) + " bytes");
  return {};
}

// Splits the first field at its semicolons.
Read<void> read_head(std::string_view field, AgentMessage& message) {
  if (field.size() > max_attribute_bytes)
    return oversized("a message's kind has too many attributes");
  const auto end_of_kind = std::min(field.find(';'), field.size());
  const auto kind = kind_of(field.substr(0, end_of_kind));
  if (!kind)
    return tl::make_unexpected(WireError{
        WireErrorKind::unknown,
        "there is no kind of message called '" + excerpt(field, 32) + "'"});
  message.kind = *kind;
  AttributeReader reader(message);
  auto rest = field.substr(end_of_kind);
  while (!rest.empty()) {
    rest.remove_prefix(1); // the semicolon
    const auto end = std::min(rest.find(';'), rest.size());
    if (auto read = reader.take(rest.substr(0, end)); !read)
      return read;
    rest.remove_prefix(end);
  }
  return {};
}

// An empty field means the time of arrival.
Read<void> read_time(std::string_view field, AgentMessage& message) {
  if (field.empty())
    return {};
  message.time = number_of(field);
  if (!message.time)
    return malformed("the second field is the time in milliseconds since "
                     "1970, or empty, not '" +
                     excerpt(field, 32) + "'");
  return {};
}

// The format of the payload is the last parameter; its bytes are not among the
// fields. The position was read as an attribute.
Read<void> read_payload(AgentMessage& message) {
  const auto position =
      message.payload ? message.payload->position : std::nullopt;
  if (message.kind != MessageKind::binary) {
    message.payload.reset();
    return {};
  }
  if (message.parameters.empty())
    return malformed("a binary message has its payload's format");
  message.payload = Payload{std::move(message.parameters.back()), {}, position};
  message.parameters.pop_back();
  if (position && *position > message.parameters.size())
    return malformed("the payload's position is beyond the parameters");
  return {};
}

// -- writing ------------------------------------------------------------------

void add(std::string& head, char letter, std::string_view value) {
  head += ';';
  head += letter;
  head += '=';
  head += value;
}

void add(std::string& head, char letter, std::uint64_t number) {
  add(head, letter, std::string_view());
  append_number(head, number);
}

// What must hold before a message may leave.
Read<void> check(const AgentMessage& message) {
  if (!message.session.empty() && !is_attribute_text(message.session))
    return malformed("a session cannot be called '" + excerpt(message.session) +
                     "'");
  for (const auto& sink : message.sinks)
    if (!is_attribute_text(sink))
      return malformed("a sink cannot be called '" + excerpt(sink) + "'");
  return check_size(message);
}

// A letter between a semicolon and an equals sign, and the digits of the
// largest number.
constexpr std::size_t letter_bytes = 3;
constexpr std::size_t number_bytes = letter_bytes + 19;

// At least as long as the first field is once the message has a number and an
// acknowledgement.
std::size_t most_of_head(const AgentMessage& message) {
  constexpr std::size_t longest_kind = 7;
  auto size = longest_kind + letter_bytes + message.session.size() +
              (number_attributes.size() + 1) * number_bytes + letter_bytes + 1;
  for (const auto& sink : message.sinks)
    size += letter_bytes + sink.size();
  return size;
}

// `more` will be added. Few messages are so long that they must be written to
// be measured.
Read<void> check_head(const AgentMessage& message, std::size_t more) {
  if (most_of_head(message) > max_attribute_bytes &&
      attributes_of(message).size() + more > max_attribute_bytes)
    return oversized("a message's kind has too many attributes");
  return {};
}

// A message without parameters may leave out empty fields at its end.
void drop_empty_end(std::vector<std::string>& fields) {
  while (fields.size() > 1 && fields.back().empty())
    fields.pop_back();
}

} // namespace

std::size_t content_bytes(const AgentMessage& message) {
  auto bytes = message.component.size() + message.command.size();
  for (const auto& parameter : message.parameters)
    bytes += parameter.size();
  if (message.payload)
    bytes += message.payload->format.size() + message.payload->bytes.size();
  return bytes;
}

std::string_view name_of(MessageKind kind) {
  return kind_names.at(static_cast<std::size_t>(kind));
}

void append_number(std::string& text, std::uint64_t number) {
  std::array<char, 20> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), end.ptr);
}

void append_attributes(std::string& text, const AgentMessage& message) {
  text += name_of(message.kind);
  if (!message.session.empty())
    add(text, 's', message.session);
  for (const auto& sink : message.sinks)
    add(text, 'k', sink);
  // Attributes that are absent are left out.
  for (const auto& attribute : number_attributes)
    if (const auto& number = message.*attribute.member)
      add(text, attribute.letter, *number);
  if (message.payload && message.payload->position)
    add(text, 'p', *message.payload->position);
  if (message.gap)
    add(text, 'g', "1");
}

std::string attributes_of(const AgentMessage& message) {
  std::string head;
  append_attributes(head, message);
  return head;
}

Read<void> check_writable(const AgentMessage& message) {
  if (auto checked = check(message); !checked)
    return checked;
  return check_head(message, 0);
}

Read<std::vector<std::string>> fields_of(const AgentMessage& message) {
  if (auto checked = check_writable(message); !checked)
    return tl::make_unexpected(std::move(checked.error()));
  std::vector<std::string> fields;
  fields.reserve(first_parameter + message.parameters.size() + 1);
  fields.push_back(attributes_of(message));
  fields.push_back(message.time ? std::to_string(*message.time) : "");
  fields.push_back(message.component);
  fields.push_back(message.command);
  fields.insert(fields.end(), message.parameters.begin(),
                message.parameters.end());
  if (message.payload)
    fields.push_back(message.payload->format);
  if (fields.size() == first_parameter)
    drop_empty_end(fields);
  return fields;
}

Read<void> check_numbered(const AgentMessage& message) {
  if (auto checked = check(message); !checked)
    return checked;
  return check_head(message, (message.number ? 0 : number_bytes) +
                                 (message.acknowledged ? 0 : number_bytes));
}

Read<void> read_message(const std::vector<std::string_view>& fields,
                        std::size_t payload_bytes, AgentMessage& message) {
  // Fields that are missing at the end count as empty.
  const auto at = [&](std::size_t position) {
    return position < fields.size() ? fields[position] : std::string_view();
  };
  if (auto read = read_head(at(0), message); !read)
    return read;
  if (auto read = read_time(at(1), message); !read)
    return read;
  message.component = at(2);
  message.command = at(3);
  if (fields.size() > first_parameter)
    message.parameters.assign(fields.begin() + first_parameter, fields.end());
  if (auto read = read_payload(message); !read)
    return read;
  return check_size(message, payload_bytes);
}

Read<AgentMessage> message_of(const std::vector<std::string_view>& fields,
                              std::size_t payload_bytes) {
  Read<AgentMessage> message;
  if (auto read = read_message(fields, payload_bytes, *message); !read)
    message = tl::make_unexpected(std::move(read.error()));
  return message;
}

bool is_binary(std::string_view head) {
  return head.substr(0, head.find(';')) == name_of(MessageKind::binary);
}

} // namespace parlour::adapters::agents
