// Writes and reads messages as lines of text, the form that they have on a TCP
// connection (adapters/agents/PROTOCOL.md 2.1 and 2.2).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// The line with its line break, followed by the payload. Errors as those of
// fields_of().
Read<std::string> line_of(const AgentMessage& message);

// Escapes and doubled quotation marks make a line longer than its message.
inline constexpr std::size_t max_line_bytes =
    2 * max_message_bytes + 2 * max_attribute_bytes;

// Splits a stream of bytes into messages. The bytes are not trusted. It holds
// at most one incomplete message and the bytes of the last add(). Not
// thread-safe.
//
//  reader.add(bytes);
//  while (auto read = reader.next())
//    *read ? take(**read) : tell(read->error());
class LineReader {
public:
  void add(std::string_view bytes);

  // The next complete message, or what is wrong with it; nothing if more bytes
  // are needed. After an error that closes the connection (closes_connection)
  // nothing more can be read.
  std::optional<Read<AgentMessage>> next();

private:
  std::optional<std::string_view> line();
  std::optional<Read<AgentMessage>> take(std::string_view line);
  std::optional<Read<AgentMessage>> payload();
  void let_go_of_what_was_read();

  // What has arrived. Bytes before at_ have been read, and between at_ and
  // scanned_ no line ends, so that no byte is searched twice.
  std::string held_;
  std::size_t at_ = 0;
  std::size_t scanned_ = 0;
  // The message whose payload has not arrived completely, and the payload's
  // length.
  std::optional<Read<AgentMessage>> waiting_;
  std::size_t wanted_ = 0;
};

} // namespace parlour::adapters::agents
