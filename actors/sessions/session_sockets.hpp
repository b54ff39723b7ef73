// SessionSockets: the TCP clients of one session, between its conversation and
// the adapter that knows the network. What the adapter's thread tells becomes a
// message of the session's mailbox. Lives in the session's actor; all sockets
// are closed when it goes.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include <caf/actor_control_block.hpp>

#include "actors/protocol/interfaces.hpp"
#include "actors/support/node_time.hpp"
#include "script/dialogue/agenda/port.hpp"

namespace parlour::actors {

// The ids are the conversation's; the network's own are known here alone.
class SessionSockets {
public:
  // `network` may be null: this run has none.
  SessionSockets(NodeTime& time, std::shared_ptr<Sockets> network,
                 const session_actor& session);
  SessionSockets(const SessionSockets&) = delete;
  SessionSockets& operator=(const SessionSockets&) = delete;
  ~SessionSockets() {
    close_all();
  }

  // False where this run has no network.
  // True says only that it is tried: SocketEvent opened or failed follows.
  bool open(dialogue::SocketRequest request);
  // An error of kind Network where it is closed.
  Expected<void> send(dialogue::SocketId id, const std::string& text);
  // The conversation has dealt with a text: the next may be read.
  void taken(dialogue::SocketId id);
  void close(dialogue::SocketId id);
  void close_all();

  // What was told as a message from the socket to this session; nothing where
  // it was closed meanwhile.
  std::optional<Message> message(dialogue::SocketId id,
                                 const SocketEvent& event,
                                 const SessionId& session) const;
  // It is over by itself.
  void forget(dialogue::SocketId id);

private:
  struct Socket {
    Sockets::Id id = 0; // as the adapter knows it
    std::string name;
  };

  NodeTime& time_;
  const std::shared_ptr<Sockets> network_;
  const caf::weak_actor_ptr session_; // weak: its actor holds this
  std::map<dialogue::SocketId, Socket> sockets_;
};

} // namespace parlour::actors
