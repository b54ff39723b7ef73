#include "actors/sessions/session_sockets.hpp"

#include <utility>

#include <caf/send.hpp>

namespace parlour::actors {

namespace {

// From the adapter's thread: the session may be gone.
Sockets::Tell teller(NodeTime& time, caf::weak_actor_ptr session,
                     dialogue::SocketId id) {
  return [&time, session = std::move(session), id](SocketEvent event) {
    auto work = time.work.begin();
    time.main_thread.post(
        [session, id, event = std::move(event), work = std::move(work)] {
          if (auto actor = caf::actor_cast<caf::strong_actor_ptr>(session))
            caf::anon_send(caf::actor_cast<session_actor>(actor),
                           socket_told{id, event, work});
        });
  };
}

} // namespace

SessionSockets::SessionSockets(NodeTime& time, std::shared_ptr<Sockets> network,
                               const session_actor& session)
    : time_(time), network_(std::move(network)),
      session_(caf::actor_cast<caf::weak_actor_ptr>(session)) {}

void SessionSockets::close_all() {
  for (const auto& [id, socket] : std::exchange(sockets_, {}))
    network_->close(socket.id);
}

// The name is kept before the adapter is called, as it may tell at once.
bool SessionSockets::open(dialogue::SocketRequest request) {
  if (!network_)
    return false;
  auto& socket = sockets_[request.id];
  socket.name = std::move(request.name);
  socket.id = network_->open(std::move(request.order),
                             teller(time_, session_, request.id));
  return true;
}

Expected<void> SessionSockets::send(dialogue::SocketId id,
                                    const std::string& text) {
  const auto found = sockets_.find(id);
  if (found == sockets_.end())
    return fail(ErrorKind::network, "it is closed");
  return network_->send(found->second.id, text);
}

void SessionSockets::taken(dialogue::SocketId id) {
  if (const auto found = sockets_.find(id); found != sockets_.end())
    network_->taken(found->second.id);
}

void SessionSockets::close(dialogue::SocketId id) {
  if (const auto socket = sockets_.extract(id))
    network_->close(socket.mapped().id);
}

void SessionSockets::forget(dialogue::SocketId id) {
  sockets_.erase(id);
}

// A text comes as the event Data of a source with the socket's name, the end as
// Closed with the reason.
std::optional<Message> SessionSockets::message(dialogue::SocketId id,
                                               const SocketEvent& event,
                                               const SessionId& session) const {
  const auto found = sockets_.find(id);
  if (found == sockets_.end())
    return {};
  Message message;
  message.source = found->second.name;
  message.command = event.kind == SocketEvent::Kind::closed ? "Closed" : "Data";
  message.params = {event.text};
  message.session = session;
  return message;
}

} // namespace parlour::actors
