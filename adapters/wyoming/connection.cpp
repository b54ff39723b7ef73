#include "adapters/wyoming/connection.hpp"

#include <array>
#include <cstring>
#include <utility>

#include <asio/connect.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/write.hpp>

namespace parlour::adapters::wyoming {

namespace {

using asio::ip::tcp;
using Steady = std::chrono::steady_clock;

// All addresses of the name; they are tried in this order.
std::vector<tcp::endpoint> endpoints_of(const std::vector<Endpoint>& found) {
  std::vector<tcp::endpoint> endpoints;
  for (const auto& one : found) {
    tcp::endpoint made;
    made.resize(one.size);
    std::memcpy(made.data(), &one.address, one.size);
    endpoints.push_back(made);
  }
  return endpoints;
}

} // namespace

// Handlers share it: they may come after the connection has gone.
//
// The alarm has two meanings: until the connection is open it limits
// connecting, then the silence of the server.
struct Connection::State : std::enable_shared_from_this<State> {
  State(const Route& way, ConnectionCalls told)
      : loop(way.loop), calls(std::move(told)), socket(way.loop.context()),
        alarm(way.loop, [this] {
          close(is_open ? "it does not answer in time"
                        : "it takes too long to connect");
        }) {}

  // The name was looked up on another thread meanwhile.
  void resolved(const Endpoints& found) {
    if (is_over)
      return;
    if (!found)
      return close(found.error().message);
    asio::async_connect(
        socket, endpoints_of(*found),
        [self = shared_from_this()](const asio::error_code& error,
                                    const tcp::endpoint&) {
          if (!self->is_over)
            self->connected(error);
        });
  }

  void connected(const asio::error_code& error) {
    if (error)
      return close("it cannot be reached: " + error.message());
    asio::error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    // Otherwise megabytes would wait there that are counted nowhere.
    socket.set_option(tcp::socket::send_buffer_size(system_buffer), ignored);
    is_open = true;
    expect(patience);
    read();
    write();
  }

  void read() {
    if (is_paused || std::exchange(is_reading, true))
      return;
    socket.async_read_some(
        asio::buffer(buffer),
        [self = shared_from_this()](const asio::error_code& error,
                                    std::size_t size) {
          if (!self->is_over)
            self->read_done(error, size);
        });
  }

  // Whoever is told may end the connection.
  // Each event shows that the server lives: the limit of its silence ends with
  // it, and whoever expects more says so again.
  void read_done(const asio::error_code& error, std::size_t size) {
    is_reading = false;
    if (error)
      return close(reader.is_inside() ? "it was cut off within an event"
                                      : "it has ended the connection");
    auto events = reader.take({buffer.data(), size});
    if (!events)
      return close(events.error().message);
    const auto told = calls.received;
    for (auto& event : *events) {
      expect(Milliseconds(0));
      told(std::move(event));
      if (is_over)
        return;
    }
    read();
  }

  // Counted with what is on its way: a server that stops reading does not make
  // this process grow.
  void send(const std::string& bytes) {
    if (is_over)
      return;
    if (waiting.size() + sending.size() + bytes.size() > max_unsent)
      return close("it takes too little of what is sent");
    waiting += bytes;
    if (is_open && sending.empty())
      write();
  }

  // One write at a time: all that has come meanwhile goes next, in one piece.
  void write() {
    sending = std::exchange(waiting, {});
    if (sending.empty())
      return;
    asio::async_write(socket, asio::buffer(sending),
                      [self = shared_from_this()](const asio::error_code& error,
                                                  std::size_t) {
                        if (self->is_over || error)
                          return; // reading says why
                        self->write();
                      });
  }

  void expect(Milliseconds within) {
    patience = within;
    if (is_open)
      alarm.set(within > Milliseconds(0) ? Steady::now() + within
                                         : Alarm::never);
  }

  void end() {
    is_over = true;
    alarm.set(Alarm::never);
    asio::error_code ignored;
    socket.close(ignored);
  }

  // The connection may be destroyed by who is told.
  void close(const std::string& reason) {
    const auto self = shared_from_this();
    end();
    if (const auto told = std::exchange(calls.closed, nullptr))
      told(reason);
  }

  Loop& loop;
  ConnectionCalls calls;
  tcp::socket socket;
  Alarm alarm;
  EventReader reader;
  std::array<char, 16'384> buffer{};
  std::string waiting;
  std::string sending;
  Milliseconds patience{0};
  bool is_open = false;
  bool is_reading = false;
  bool is_paused = false;
  bool is_over = false;
};

Connection::Connection(const Route& route, ConnectionCalls calls)
    : state_(std::make_shared<State>(route, std::move(calls))) {
  state_->alarm.set(Steady::now() + route.connect_timeout);
  route.resolver.resolve(route.address,
                         [&loop = route.loop, weak = std::weak_ptr(state_)](
                             const Endpoints& found) {
                           loop.post([weak, found] {
                             if (const auto state = weak.lock())
                               state->resolved(found);
                           });
                         });
}

// Handlers that are under way keep the state for a moment; what was told of may
// have gone then.
Connection::~Connection() {
  state_->end();
  state_->calls = {};
}

void Connection::send(const Event& event) {
  state_->send(encode(event));
}

void Connection::expect(Milliseconds within) {
  state_->expect(within);
}

void Connection::pause() {
  state_->is_paused = true;
}

void Connection::resume() {
  state_->is_paused = false;
  if (state_->is_open && !state_->is_over)
    state_->read();
}

} // namespace parlour::adapters::wyoming
