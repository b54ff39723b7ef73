#include "script/dialogue/engine/effects/sockets.hpp"

#include <algorithm>
#include <utility>

#include "runtime/message/roles.hpp"

namespace parlour::dialogue {

namespace {

// Of one session (language rule 11.9).
constexpr std::size_t max_sockets = 16;

Error network(std::string message) {
  return {ErrorKind::network, std::move(message), {}};
}

} // namespace

Expected<void> ScriptSockets::may_open(const std::string& name) const {
  // Its messages must not pass for those of somebody else.
  if (!wrong_source_name(name).empty() || context_.port.reachable(name))
    return fail(ErrorKind::refused,
                "a socket cannot be called '" + name +
                    "': it needs a name that no role and no component has");
  if (sockets_.contains(name))
    return fail(ErrorKind::network,
                "there is a socket '" + name + "' already; close it before");
  if (sockets_.size() >= max_sockets)
    return fail(ErrorKind::network, "a session has no more than " +
                                        std::to_string(max_sockets) +
                                        " sockets");
  return {};
}

void ScriptSockets::open(const script::Effect& effect, WaitId wait) {
  SocketRequest request;
  request.id = context_.next_id();
  request.name = effect.text(0);
  request.order.address = effect.text(1);
  request.order.lines = !effect.has(2) || static_cast<bool>(effect.operand(2));
  request.order.timeout = context_.program->settings.sessions.request_timeout;
  sockets_[request.name] = {request.id, wait};
  context_.port.open_socket(std::move(request));
}

script::Performed ScriptSockets::send(const script::Effect& effect) {
  const auto name = effect.text(0);
  const auto found = sockets_.find(name);
  if (found == sockets_.end() || found->second.opening != 0)
    return network("there is no open socket '" + name + "'");
  auto sent = context_.port.send_socket(found->second.id, effect.text(1));
  if (!sent)
    return network("socket '" + name + "': " + sent.error().message);
  return Value();
}

// Nothing where it is closed already. One that is being opened belongs to the
// script that waits for it.
script::Performed ScriptSockets::close(const script::Effect& effect) {
  const auto name = effect.text(0);
  const auto found = sockets_.find(name);
  if (found == sockets_.end())
    return Value();
  if (found->second.opening != 0)
    return network("socket '" + name + "' is not open yet");
  context_.port.close_socket(found->second.id);
  sockets_.erase(found);
  return Value();
}

ScriptSockets::Entries::iterator ScriptSockets::find(SocketId id) {
  return std::find_if(sockets_.begin(), sockets_.end(),
                      [&](const auto& entry) { return entry.second.id == id; });
}

std::optional<WaitOutcome> ScriptSockets::opened(SocketId id,
                                                 Expected<void> outcome) {
  const auto found = find(id);
  if (found == sockets_.end())
    return std::nullopt;
  const auto wait = std::exchange(found->second.opening, 0);
  if (!outcome)
    sockets_.erase(found);
  return WaitOutcome{wait, std::move(outcome).map([] { return Value(true); })};
}

void ScriptSockets::closed(SocketId id) {
  if (const auto found = find(id); found != sockets_.end())
    sockets_.erase(found);
}

// The port is told only when the pipeline is done with a text: so a script that
// is slow makes the other side wait, and no memory fills.
void ScriptSockets::let_next_come(const Message& message) {
  if (const auto found = sockets_.find(message.source);
      found != sockets_.end() && message.command == "Data")
    context_.port.socket_taken(found->second.id);
}

// A connection that comes up after its script was ended has no owner, so it is
// closed.
void ScriptSockets::forget(WaitId wait) {
  for (const auto& [name, socket] : sockets_)
    if (socket.opening == wait)
      context_.port.close_socket(socket.id);
  std::erase_if(sockets_, [&](const auto& entry) {
    return entry.second.opening == wait;
  });
}

// TCP connections do not outlive their process. Scripts hear of it as if the
// other side had closed.
std::vector<WaitOutcome> ScriptSockets::lose_all(Inbox& inbox) {
  const std::string why = "the connection was lost when the session was "
                          "interrupted";
  std::vector<WaitOutcome> lost;
  for (const auto& [name, socket] : std::exchange(sockets_, {}))
    if (socket.opening != 0)
      lost.push_back({socket.opening, tl::make_unexpected(network(why))});
    else
      inbox.receive({.message = std::make_shared<const Message>(
                         closed_event(name, why))});
  return lost;
}

Message ScriptSockets::closed_event(const std::string& name,
                                    const std::string& why) const {
  Message message;
  message.time = context_.now;
  message.source = name;
  message.command = "Closed";
  message.params = {why};
  message.session = context_.options.session;
  return message;
}

bool ScriptSockets::waits_for_answer() const {
  return std::any_of(sockets_.begin(), sockets_.end(), [](const auto& entry) {
    return entry.second.opening != 0;
  });
}

} // namespace parlour::dialogue
