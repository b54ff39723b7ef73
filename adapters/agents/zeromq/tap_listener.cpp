#include "adapters/agents/zeromq/tap_listener.hpp"

#include <chrono>
#include <iterator>
#include <string_view>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>
#include <zmq.hpp>
#include <zmq_addon.hpp>

#include "adapters/agents/wire/multipart.hpp"

namespace parlour::adapters::agents {

struct TapListener::Socket {
  zmq::context_t zeromq;
  zmq::socket_t subscriber{zeromq, zmq::socket_type::sub};
  int stopped = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);

  Socket() = default;
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() {
    close(stopped);
  }
};

TapListener::TapListener(std::unique_ptr<Socket> socket)
    : socket_(std::move(socket)) {}

TapListener::~TapListener() = default;

Expected<std::unique_ptr<TapListener>>
TapListener::connect(const std::string& address,
                     const std::vector<std::string>& beginnings) {
  try {
    auto socket = std::make_unique<Socket>();
    auto& subscriber = socket->subscriber;
    subscriber.set(zmq::sockopt::linger, 0);
    subscriber.set(zmq::sockopt::ipv6, true);
    subscriber.set(zmq::sockopt::maxmsgsize,
                   static_cast<std::int64_t>(2 * max_message_bytes));
    for (const auto& beginning : beginnings)
      subscriber.set(zmq::sockopt::subscribe, beginning);
    if (beginnings.empty())
      subscriber.set(zmq::sockopt::subscribe, "");
    subscriber.connect(address);
    return std::unique_ptr<TapListener>(new TapListener(std::move(socket)));
  } catch (const zmq::error_t& error) {
    return fail(ErrorKind::settings,
                address + ": " + error.what() +
                    "; write an address such as tcp://127.0.0.1:5673");
  }
}

std::optional<Read<AgentMessage>> TapListener::next() {
  std::vector<zmq::pollitem_t> awaited = {
      {socket_->subscriber.handle(), 0, ZMQ_POLLIN, 0},
      {nullptr, socket_->stopped, ZMQ_POLLIN, 0}};
  do {
    try {
      zmq::poll(awaited, std::chrono::milliseconds(-1));
    } catch (const zmq::error_t& error) {
      if (error.num() != EINTR)
        throw;
    }
    if (awaited[1].revents != 0)
      return std::nullopt;
  } while (awaited[0].revents == 0);
  std::vector<zmq::message_t> frames;
  static_cast<void>(
      zmq::recv_multipart(socket_->subscriber, std::back_inserter(frames)));
  std::vector<std::string_view> fields;
  // The first frame is what listeners choose by.
  for (auto frame = frames.begin() + 1; frame < frames.end(); ++frame)
    fields.push_back(frame->to_string_view());
  return read_frames(std::move(fields));
}

void TapListener::stop() {
  eventfd_write(socket_->stopped, 1);
}

} // namespace parlour::adapters::agents
