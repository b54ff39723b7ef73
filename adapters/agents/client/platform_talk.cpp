#include "adapters/agents/client/platform_talk.hpp"

#include <utility>

#include <fmt/format.h>

#include "adapters/agents/delivery/exchange.hpp"
#include "adapters/agents/delivery/steady_time.hpp"

namespace parlour::adapters::agents {

namespace {

bool ends_for_good(WireErrorKind kind) {
  using enum WireErrorKind;
  return kind == identity || kind == version || kind == replaced;
}

} // namespace

PlatformTalk::PlatformTalk(Hello hello, SharedLink& link, Owner& owner)
    : hello_(std::move(hello)), link_(link), owner_(owner) {}

void PlatformTalk::say_hello(PeerConnection& connection, bool reads_packed) {
  hello_.introduction = link_.introduction();
  hello_.introduction.packed = reads_packed;
  connection.write(hello_message(hello_));
}

void PlatformTalk::take(PeerConnection& connection,
                        Read<AgentMessage>&& message, Timestamp now) {
  message ? take_message(connection, std::move(*message), now)
          : tell(connection, message.error());
}

void PlatformTalk::take_message(PeerConnection& connection,
                                AgentMessage&& message, Timestamp now) {
  if (message.kind == MessageKind::welcome)
    take_welcome(connection, message);
  else if (message.kind == MessageKind::error)
    take_error(message);
  else if (message.kind == MessageKind::bye)
    owner_.lose("the platform has said goodbye");
  else if (link_.is_connected())
    hand_on(connection, std::move(message), now);
}

void PlatformTalk::take_welcome(PeerConnection& connection,
                                const AgentMessage& message) {
  const auto welcome = welcome_of(message);
  if (!welcome)
    return owner_.lose("the platform's welcome: " + welcome.error().sentence);
  if (auto checked = check_version(*welcome, hello_); !checked) {
    write_error(connection, checked.error());
    return owner_.end(
        {ErrorKind::refused, "version: " + checked.error().sentence, {}});
  }
  if (link_.is_behind(welcome->introduction)) {
    link_.renew(new_incarnation());
    return owner_.lose("the platform knows of messages that were never sent");
  }
  link_.connect(welcome->introduction, steady_now());
  mistakes_ = 0;
  if (welcome->introduction.packed)
    connection.pack();
  owner_.welcomed();
}

void PlatformTalk::take_error(const AgentMessage& message) {
  // It ends a request of the agent, or is about an answer of the agent's.
  if (message.correlation)
    return owner_.received(AgentMessage(message));
  const auto sentence =
      message.parameters.empty() ? "" : message.parameters.front();
  const auto kind = error_kind_of(message.command);
  if (kind && ends_for_good(*kind))
    return owner_.end(
        {ErrorKind::refused, message.command + ": " + sentence, {}});
  owner_.note("the platform says " + message.command + ": " + sentence);
  // The platform does not know this connection, or closes it.
  if (kind == WireErrorKind::unknown ||
      (kind && closes_connection({*kind, {}})))
    owner_.lose("the platform refuses what the agent says");
}

void PlatformTalk::hand_on(PeerConnection& connection, AgentMessage&& message,
                           Timestamp now) {
  auto arrival = link_.receive(message, now);
  if (arrival.error)
    return tell(connection, *arrival.error);
  mistakes_ = 0;
  if (arrival.deliver)
    owner_.received(std::move(message));
}

// A mistake of the platform (adapters/agents/PROTOCOL.md 5). Nobody is told
// before the welcome.
void PlatformTalk::tell(PeerConnection& connection, const WireError& error) {
  const auto now = steady_now();
  if (now - std::exchange(noted_, now) >= 1000)
    owner_.note(fmt::format("the platform's message is {}: {}",
                            name_of(error.kind), error.sentence));
  if (link_.is_connected())
    write_error(connection, error);
  if (++mistakes_ >= AgentExchange::max_malformed || closes_connection(error))
    owner_.lose("the platform makes mistakes");
}

void PlatformTalk::write_error(PeerConnection& connection,
                               const WireError& error) const {
  auto message = error_message(error);
  message.component = hello_.name;
  connection.write(message);
}

} // namespace parlour::adapters::agents
