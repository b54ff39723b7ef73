// AgentMessage is a message between a remote agent and the platform, as data,
// and as the list of fields that both transports carry
// (adapters/agents/PROTOCOL.md 1). A plain value: nothing here knows a socket.
//
//  text;s=K3f9;n=12 , 1732178400123 , Robot     , Goto    , lobby , 3
//  kind, attributes   time            component   command   parameters
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/agents/wire/wire_error.hpp"

namespace parlour::adapters::agents {

enum class MessageKind : std::uint8_t {
#define X(name, sentence) name,
#include "adapters/agents/wire/message_kinds.def"
#undef X
};

std::string_view name_of(MessageKind kind);

// The limits of adapters/agents/PROTOCOL.md 1.6. The size of a message is that
// of component, command, parameters and payload, as they are in memory.
inline constexpr std::size_t max_message_bytes = 1 << 20;
inline constexpr std::size_t max_parameters = 64;
inline constexpr std::size_t max_attribute_bytes = 1024;

// Bytes that travel with a message, such as audio.
struct Payload {
  std::string format; // "pcm_s16le;rate=16000;channels=1"
  std::string bytes;
  // Its index among the parameters, from 0. If it is absent, the payload
  // follows the last parameter.
  std::optional<std::uint64_t> position;

  bool operator==(const Payload&) const = default;
};

// The letter beside a member is that of its attribute on the wire
// (adapters/agents/PROTOCOL.md 1.2). A member is empty if the message does not
// have the attribute.
struct AgentMessage {
  MessageKind kind = MessageKind::text;
  std::string session;                       // s
  std::vector<std::string> sinks;            // k
  std::optional<std::uint64_t> number;       // n
  std::optional<std::uint64_t> acknowledged; // a
  std::optional<std::uint64_t> window;       // w
  std::optional<std::uint64_t> correlation;  // c
  std::optional<std::uint64_t> deadline;     // d, in milliseconds
  bool gap = false;                          // g
  std::optional<std::uint64_t> time;         // milliseconds since 1970
  std::string component;
  std::string command;
  std::vector<std::string> parameters; // without the payload
  std::optional<Payload> payload;      // of a `binary` message

  bool operator==(const AgentMessage&) const = default;
};

// What counts towards the limit of a message.
std::size_t content_bytes(const AgentMessage& message);

// The first field: "text;s=K3f9;n=12".
std::string attributes_of(const AgentMessage& message);
void append_attributes(std::string& text, const AgentMessage& message);
void append_number(std::string& text, std::uint64_t number);
// Whether the message can be written as it is. Errors as those of fields_of().
Read<void> check_writable(const AgentMessage& message);

// All fields but the payload's bytes, which each transport carries in its own
// way. Empty fields at the end are left out if there are no parameters. The
// kind of an error is `malformed` if an attribute holds what 1.2 does not
// allow, and `oversized` beyond the limits of 1.6; such a message must not be
// sent.
Read<std::vector<std::string>> fields_of(const AgentMessage& message);

// Whether the message can be written once it has a number and an
// acknowledgement, however many digits they have. Errors as those of
// fields_of().
Read<void> check_numbered(const AgentMessage& message);

// Reads a message from its fields. The caller adds the payload's bytes, which
// count towards the size. The fields are not trusted: every value is checked.
Read<AgentMessage> message_of(const std::vector<std::string_view>& fields,
                              std::size_t payload_bytes = 0);
// The same into a message that has no field yet. After an error it is of no
// use.
Read<void> read_message(const std::vector<std::string_view>& fields,
                        std::size_t payload_bytes, AgentMessage& message);

// Whether the first field, "binary;n=12", says that a payload follows.
bool is_binary(std::string_view head);

} // namespace parlour::adapters::agents
