// Outbox holds what a link has not been told to be received: a queue of
// messages in a ring, whose memory is used again and again.
#pragma once

#include <cstddef>
#include <vector>

#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// A queue with access by position, 0 being the oldest. Not thread-safe.
class Outbox {
public:
  std::size_t size() const {
    return size_;
  }
  bool empty() const {
    return size_ == 0;
  }
  AgentMessage& operator[](std::size_t position) {
    return ring_[(first_ + position) & (ring_.size() - 1)];
  }
  AgentMessage& front() {
    return (*this)[0];
  }

  void push_back(AgentMessage&& message);
  // Frees what the message holds. If nothing is left, a large ring is freed,
  // too.
  void pop_front();
  // Takes all messages out, in their order.
  std::vector<AgentMessage> take();

private:
  void grow();
  void free_memory();

  // Its size is a power of two, or 0. Messages that are not in the queue any
  // more mean nothing.
  std::vector<AgentMessage> ring_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

} // namespace parlour::adapters::agents
