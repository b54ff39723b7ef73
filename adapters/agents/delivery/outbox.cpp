#include "adapters/agents/delivery/outbox.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::agents {
namespace {

constexpr std::size_t smallest_ring = 8;
// Kept although it is empty.
constexpr std::size_t usual_ring = 16;
// The longest message whose memory is kept for a while.
constexpr std::size_t most_kept = 4096;

} // namespace

void Outbox::push_back(AgentMessage&& message) {
  if (size_ == ring_.size())
    grow();
  (*this)[size_] = std::move(message);
  ++size_;
}

void Outbox::pop_front() {
  if (content_bytes(front()) > most_kept)
    const AgentMessage gone(std::move(front()));
  first_ = (first_ + 1) & (ring_.size() - 1);
  if (--size_ == 0)
    free_memory();
}

void Outbox::free_memory() {
  if (ring_.size() > usual_ring)
    ring_ = {};
  for (auto& message : ring_)
    if (!message.parameters.empty() || message.payload)
      const AgentMessage gone(std::move(message));
}

std::vector<AgentMessage> Outbox::take() {
  std::vector<AgentMessage> all;
  all.reserve(size_);
  for (std::size_t i = 0; i < size_; ++i)
    all.push_back(std::move((*this)[i]));
  *this = {};
  return all;
}

void Outbox::grow() {
  const auto size = std::max(smallest_ring, 2 * ring_.size());
  auto all = take();
  size_ = all.size();
  all.resize(size);
  ring_ = std::move(all);
}

} // namespace parlour::adapters::agents
