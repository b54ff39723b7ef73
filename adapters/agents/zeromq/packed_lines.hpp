// Many messages as one message of ZeroMQ (adapters/agents/PROTOCOL.md 2.5),
// which costs a fraction of one for each.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include <zmq.hpp>

#include "adapters/agents/wire/agent_message.hpp"
#include "adapters/agents/wire/text_line.hpp"

namespace parlour::adapters::agents {

// A single frame holds lines, at most so many bytes.
inline constexpr std::size_t max_packed_bytes = 256 << 10;

// Whether a message is packed; a longer one travels by itself.
bool may_be_packed(const AgentMessage& message);

// What is to leave together.
class PackedLines {
public:
  bool empty() const {
    return lines_.empty();
  }
  // It should be sent before anything is added.
  bool is_full() const {
    return lines_.size() >= full_bytes;
  }
  // A message that cannot be written is dropped: whoever writes it has checked
  // it.
  void add(const AgentMessage& message);
  // Sends them as one frame, and is empty then. If the socket's queue is full,
  // the messages are dropped. Throws zmq::error_t.
  void send(zmq::socket_t& socket);

private:
  static constexpr std::size_t full_bytes = 64 << 10;

  std::string lines_;
};

// Reads them. Not thread-safe.
class PackedReader {
public:
  // Gets each message, or what is wrong with it.
  using Take = std::function<void(Read<AgentMessage>&& message)>;
  void read(std::string_view lines, const Take& take);

private:
  LineReader reader_; // kept for its memory
};

} // namespace parlour::adapters::agents
