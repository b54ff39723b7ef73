// PeerConnection is one connection between an agent and the platform, of either
// side and by either transport.
#pragma once

#include "adapters/agents/delivery/peer.hpp"
#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// Used on one thread, its loop's.
class PeerConnection {
public:
  // Learns what happens. It must outlive the connection, or close it first.
  class Owner {
  public:
    virtual ~Owner() = default;
    // Bytes have arrived. The messages in them, if any, follow at once.
    virtual void heard(ConnectionId connection) = 0;
    virtual void arrived(ConnectionId connection,
                         Read<AgentMessage>&& message) = 0;
    // The other side has closed the connection, or it failed.
    virtual void lost(ConnectionId connection) = 0;
  };

  virtual ~PeerConnection() = default;
  // Begins to read. What was written before leaves as soon as it can.
  virtual void start() = 0;
  // Collects what is written in one turn of the loop, and sends it together.
  virtual void write(const AgentMessage& message) = 0;
  // From now on messages may be packed (adapters/agents/PROTOCOL.md 2.5). Lines
  // are as they are.
  virtual void pack() {}
  // Closes the connection after what was written has been sent, or after some
  // time. No further event is reported.
  virtual void close() = 0;
};

} // namespace parlour::adapters::agents
