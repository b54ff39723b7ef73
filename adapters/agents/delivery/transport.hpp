// AgentTransport: a way by which agents connect, as the server's thread sees it
// (adapters/agents/PROTOCOL.md 2).
#pragma once

#include <functional>
#include <string>

#include "adapters/agents/delivery/peer.hpp"
#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// Accepts connections, and writes messages to them. It is used on the server's
// thread only, and reports to TransportEvents.
class AgentTransport {
public:
  virtual ~AgentTransport() = default;

  // Whether the connection is one of this transport.
  virtual bool has(ConnectionId connection) const = 0;
  // The connection must be one of this transport. Writing never waits. A
  // message that cannot leave may be dropped: the link notices the gap, and
  // sends it again.
  virtual void write(ConnectionId connection, const AgentMessage& message) = 0;
  // From now on messages to this connection may be packed
  // (adapters/agents/PROTOCOL.md 2.5). Lines are as they are.
  virtual void pack(ConnectionId) {}
  // What was written before is still sent, but no further event of this
  // connection is reported.
  virtual void close(ConnectionId connection) = 0;
  // Closes all connections, and accepts no more.
  virtual void shut() = 0;
  // Only this host can connect.
  virtual bool is_loopback() const = 0;
  // Where agents connect, with the port that was chosen:
  // "tcp://127.0.0.1:5670".
  virtual std::string address() const = 0;
};

// Receives the events of all transports, on the server's thread.
class TransportEvents {
public:
  virtual ~TransportEvents() = default;
  // An id that no other connection has, of any transport.
  virtual ConnectionId next_id() = 0;
  // An agent has connected. The connection may be closed within this call.
  virtual void opened(ConnectionId connection, Peer peer) = 0;
  // Bytes have arrived, which need not be a whole message. The messages in
  // them follow at once.
  virtual void heard(ConnectionId connection) = 0;
  // A message, or the reason why what has arrived is not one.
  virtual void arrived(ConnectionId connection,
                       Read<AgentMessage>&& message) = 0;
  // The other side has closed the connection, or it failed.
  virtual void closed(ConnectionId connection) = 0;
  // A peer was not let in, so that there is no connection.
  virtual void turned_away(const std::string& peer, const WireError& error) = 0;
  // A connection could not be accepted, and is tried again later: the process
  // has too many files open, say.
  virtual void not_accepted(const std::string& reason) = 0;
};

} // namespace parlour::adapters::agents
