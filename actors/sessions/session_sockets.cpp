#include "actors/sessions/session_sockets.hpp"

#include <utility>

#include <caf/send.hpp>

namespace parlour::actors {

namespace {

// From the adapter's thread, by the session's id: the session may be gone.
Sockets::Tell teller(Services& services, SessionId session,
                     dialogue::SocketId id) {
  return [&services, session = std::move(session), id](SocketEvent event) {
    auto work = services.time.work.begin();
    services.time.gate.enter([&services, session, id, event = std::move(event),
                              work = std::move(work)] {
      if (auto actor = services.sessions.find(session))
        caf::anon_send(actor, socket_told{id, event, work});
    });
  };
}

} // namespace

void SessionSockets::close_all() {
  for (const auto& [id, socket] : std::exchange(sockets_, {}))
    services_.sockets->close(socket.id);
}

bool SessionSockets::open(dialogue::SocketRequest request) {
  if (!services_.sockets)
    return false;
  auto& socket = sockets_[request.id];
  socket.name = std::move(request.name);
  socket.id = services_.sockets->open(std::move(request.order),
                                      teller(services_, session_, request.id));
  return true;
}

Expected<void> SessionSockets::send(dialogue::SocketId id,
                                    const std::string& text) {
  const auto found = sockets_.find(id);
  if (found == sockets_.end())
    return fail(ErrorKind::network, "it is closed");
  return services_.sockets->send(found->second.id, text);
}

void SessionSockets::taken(dialogue::SocketId id) {
  if (const auto found = sockets_.find(id); found != sockets_.end())
    services_.sockets->taken(found->second.id);
}

void SessionSockets::close(dialogue::SocketId id) {
  if (const auto socket = sockets_.extract(id))
    services_.sockets->close(socket.mapped().id);
}

void SessionSockets::forget(dialogue::SocketId id) {
  sockets_.erase(id);
}

std::optional<Message> SessionSockets::message(dialogue::SocketId id,
                                               const SocketEvent& event) const {
  const auto found = sockets_.find(id);
  if (found == sockets_.end())
    return {};
  Message message;
  message.source = found->second.name;
  message.command = event.kind == SocketEvent::Kind::closed ? "Closed" : "Data";
  message.params = {event.text};
  message.session = session_;
  return message;
}

} // namespace parlour::actors
