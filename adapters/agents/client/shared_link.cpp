#include "adapters/agents/client/shared_link.hpp"

#include <utility>

namespace parlour::adapters::agents {

SharedLink::SharedLink(std::string incarnation)
    : link_(std::move(incarnation)) {}

bool SharedLink::send(AgentMessage&& message) {
  std::lock_guard lock(mutex_);
  return link_.send(std::move(message));
}

// Half of it, so that whoever sends much is not woken for each message.
bool SharedLink::has_room() const {
  return link_.has_half_free();
}

bool SharedLink::wait_for_room(Milliseconds patience) {
  std::unique_lock lock(mutex_);
  ++waiting_for_room_;
  const bool has_come =
      room_.wait_for(lock, patience, [this] { return has_room(); });
  --waiting_for_room_;
  return has_come;
}

bool SharedLink::handed_on() {
  std::lock_guard lock(mutex_);
  link_.handed_on();
  return link_.owes_many();
}

Introduction SharedLink::introduction() const {
  std::lock_guard lock(mutex_);
  return link_.introduction();
}

bool SharedLink::is_behind(const Introduction& peer) const {
  std::lock_guard lock(mutex_);
  return link_.is_behind(peer);
}

void SharedLink::renew(std::string incarnation) {
  std::lock_guard lock(mutex_);
  link_.renew(std::move(incarnation));
}

void SharedLink::connect(const Introduction& peer, Timestamp now) {
  std::lock_guard lock(mutex_);
  link_.connect(peer, now);
}

void SharedLink::disconnect() {
  std::lock_guard lock(mutex_);
  link_.disconnect();
}

std::size_t SharedLink::waiting() const {
  std::lock_guard lock(mutex_);
  return link_.waiting();
}

Link::Arrival SharedLink::receive(const AgentMessage& message, Timestamp now) {
  std::lock_guard lock(mutex_);
  auto arrival = link_.receive(message, now);
  if (waiting_for_room_ > 0 && has_room())
    room_.notify_all();
  return arrival;
}

void SharedLink::write_output(Timestamp now, const Link::Write& write) {
  std::lock_guard lock(mutex_);
  link_.write_output(now, write);
}

} // namespace parlour::adapters::agents
