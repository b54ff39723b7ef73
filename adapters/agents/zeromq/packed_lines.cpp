#include "adapters/agents/zeromq/packed_lines.hpp"

#include <memory>
#include <utility>

namespace parlour::adapters::agents {
namespace {

// Escapes can make a line twice as long as this, and much may stand before it:
// with the attributes it fits.
constexpr std::size_t longest_packed = 64 << 10;
constexpr std::size_t worth_keeping = 4 << 10;

// The frame of a text, which is empty then. ZeroMQ deletes a large text when it
// has been sent; a small one is copied, so that its memory is used again.
zmq::message_t frame_of(std::string& text) {
  if (text.size() < worth_keeping) {
    zmq::message_t frame(text.data(), text.size());
    text.clear();
    return frame;
  }
  auto kept = std::make_unique<std::string>();
  kept->swap(text);
  auto* const data = kept->data();
  const auto size = kept->size();
  return {data, size,
          [](void*, void* hint) { delete static_cast<std::string*>(hint); },
          kept.release()};
}

} // namespace

bool may_be_packed(const AgentMessage& message) {
  return content_bytes(message) <= longest_packed;
}

void PackedLines::add(const AgentMessage& message) {
  (void)append_line(lines_, message);
}

void PackedLines::send(zmq::socket_t& socket) {
  auto lines = frame_of(lines_);
  (void)socket.send(lines, zmq::send_flags::dontwait);
}

void PackedReader::read(std::string_view lines, const Take& take) {
  if (lines.size() > max_packed_bytes)
    return take(oversized("the packed messages have more than " +
                          std::to_string(max_packed_bytes) + " bytes"));
  reader_.add(lines);
  while (auto message = reader_.next()) {
    const bool ends = !*message && closes_connection(message->error());
    take(std::move(*message));
    if (ends) {
      reader_ = {}; // what follows means nothing
      return;
    }
  }
  // A part of a message has no continuation.
  if (reader_.has_part()) {
    reader_ = {};
    take(malformed("the last of the packed messages is not complete"));
  }
}

} // namespace parlour::adapters::agents
