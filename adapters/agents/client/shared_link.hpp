// SharedLink is the link of an AgentConnection. The connection's thread drives
// it, and any thread may send: where the outbox is full, the author learns it
// at once.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>

#include "adapters/agents/delivery/link.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::agents {

class SharedLink {
public:
  explicit SharedLink(std::string incarnation);

  // -- from any thread --------------------------------------------------------

  // False: the outbox is full.
  bool send(AgentMessage&& message);
  // Waits until half of the outbox is free. False: it did not happen in time.
  bool wait_for_room(Milliseconds patience);
  // True: so much is to be acknowledged that it should be done now.
  bool handed_on();

  // -- from the connection's thread: as those of Link -------------------------

  Introduction introduction() const;
  bool is_behind(const Introduction& peer) const;
  void renew(std::string incarnation);
  void connect(const Introduction& peer, Timestamp now);
  void disconnect();
  // No other thread changes it.
  bool is_connected() const {
    return link_.is_connected();
  }
  std::size_t waiting() const;
  Link::Arrival receive(const AgentMessage& message, Timestamp now);
  // `write` must not use the link.
  void write_output(Timestamp now, const Link::Write& write);

private:
  bool has_room() const;

  mutable std::mutex mutex_; // of what follows
  Link link_;
  std::condition_variable room_;
  int waiting_for_room_ = 0;
};

} // namespace parlour::adapters::agents
