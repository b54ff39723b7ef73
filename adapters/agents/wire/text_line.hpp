// Writes and reads messages as lines of text, the form that they have on a TCP
// connection (adapters/agents/PROTOCOL.md 2.1 and 2.2).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// The line with its line break, followed by the payload. Errors as those of
// fields_of().
Read<std::string> line_of(const AgentMessage& message);
// The same at the end of a text, which is left alone after an error.
Read<void> append_line(std::string& text, const AgentMessage& message);

// Escapes and doubled quotation marks make a line longer than its message.
inline constexpr std::size_t max_line_bytes =
    2 * max_message_bytes + 2 * max_attribute_bytes;

// Splits a stream of bytes into messages. The bytes are not trusted. It holds
// at most one incomplete message and the bytes that were added last. Not
// thread-safe.
//
//  reader.add(bytes);
//  while (auto read = reader.next())
//    *read ? take(**read) : tell(read->error());
class LineReader {
public:
  void add(std::string_view bytes);

  // For whoever can read bytes to where they are to be, without a copy: at
  // least so much room, valid until the next call; then how much of it was
  // used.
  std::span<char> room(std::size_t least);
  void added(std::size_t bytes);

  // The next complete message, or what is wrong with it; nothing if more bytes
  // are needed. After an error that closes the connection (closes_connection)
  // nothing more can be read.
  std::optional<Read<AgentMessage>> next();
  // Whether a part of a message has arrived.
  bool has_part() const {
    return at_ < end_ || waiting_;
  }

private:
  using Next = std::optional<Read<AgentMessage>>;

  std::optional<std::string_view> line();
  void take(std::string_view line, Next& next);
  void take_fields(Next& next);
  void take_payload(Next& next);
  void make_room(std::size_t least);
  std::string_view unread() const {
    return {held_.get() + at_, end_ - at_};
  }

  // What has arrived, up to end_. Bytes before at_ have been read, and between
  // at_ and scanned_ no line ends, so that no byte is searched twice.
  std::unique_ptr<char[]> held_;
  std::size_t capacity_ = 0;
  std::size_t end_ = 0;
  std::size_t at_ = 0;
  std::size_t scanned_ = 0;
  // The message whose payload has not arrived completely, and the payload's
  // length.
  std::optional<Read<AgentMessage>> waiting_;
  std::size_t wanted_ = 0;
  // Of the line that is being read: kept for its memory.
  std::vector<std::string_view> fields_;
};

} // namespace parlour::adapters::agents
