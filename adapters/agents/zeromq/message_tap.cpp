#include "adapters/agents/zeromq/message_tap.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include <zmq.hpp>
#include <zmq_addon.hpp>

#include "adapters/agents/wire/multipart.hpp"
#include "adapters/agents/wire/parameters.hpp"
#include "adapters/agents/zeromq/local_address.hpp"

namespace parlour::adapters::agents {

struct MessageTap::Socket {
  zmq::context_t zeromq;
  zmq::socket_t publisher{zeromq, zmq::socket_type::pub};
  std::uint64_t published = 0;
};

MessageTap::MessageTap(std::unique_ptr<Socket> socket)
    : socket_(std::move(socket)) {}

MessageTap::~MessageTap() = default;

Expected<std::unique_ptr<MessageTap>>
MessageTap::open(const std::string& address) {
  if (!is_local_address(address))
    return fail(ErrorKind::settings,
                address + " can be reached from other hosts, and taps hear "
                          "everything: listen on 127.0.0.1");
  try {
    auto socket = std::make_unique<Socket>();
    socket->publisher.set(zmq::sockopt::linger, 0);
    socket->publisher.set(zmq::sockopt::ipv6, address.starts_with("tcp://["));
    socket->publisher.bind(address);
    return std::unique_ptr<MessageTap>(new MessageTap(std::move(socket)));
  } catch (const zmq::error_t& error) {
    return fail(ErrorKind::network,
                "taps cannot connect to " + address + ": " + error.what());
  }
}

std::string MessageTap::address() const {
  return socket_->publisher.get(zmq::sockopt::last_endpoint);
}

// Every message takes a number, so that a listener notices what it missed. One
// that the wire cannot carry (with two payloads, or too large) is only such a
// gap.
void MessageTap::publish(const Message& message) {
  auto copy = message_for_agent(message, true);
  ++socket_->published;
  if (!copy)
    return;
  copy->number = socket_->published;
  const auto frames = frames_of(*copy);
  if (!frames)
    return;
  const auto topic = message.source + "." + message.command;
  std::vector<zmq::const_buffer> parts = {zmq::buffer(topic)};
  for (const auto& frame : *frames)
    parts.push_back(zmq::buffer(frame));
  zmq::send_multipart(socket_->publisher, parts, zmq::send_flags::dontwait);
}

} // namespace parlour::adapters::agents
