// AcceptorOver lets others connect to a port of this machine:
//
//  AcceptorOver<StandaloneAsio> acceptor(loop.context());
//  acceptor.open({address, port});
//  loop.post([&] { acceptor.accept({[&](auto socket) { … }}); });
//
// `Asio` is as of LoopOver. An internal header of transports that are written
// with asio.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

// Used on the thread of its context, but for what is said of open(). It
// outlives what the context does for it: it is destroyed there after close(),
// or when the context has stopped.
template <class Asio>
class AcceptorOver {
public:
  using Acceptor = typename Asio::Acceptor;
  using Endpoint = typename Acceptor::endpoint_type;
  using Socket = typename Asio::Socket;

  struct Calls {
    // Gets each connection. It may let the socket go, which closes it. What it
    // throws is the loop's to tell; others are accepted all the same.
    std::function<void(Socket)> take;
    // While it says no, who connects waits in the system (go_on()). Null: there
    // is always room.
    std::function<bool()> has_room = {};
    // Told why nobody could be accepted, each time. It may be null.
    std::function<void(const std::string& why)> failed = {};
  };

  explicit AcceptorOver(typename Asio::Context& context)
      : acceptor_(context), pause_(context) {}
  AcceptorOver(const AcceptorOver&) = delete;
  AcceptorOver& operator=(const AcceptorOver&) = delete;

  // From then on others can connect; the system keeps `waiting` of them until
  // they are accepted. Any thread may call it, before all else. The error, of
  // kind Network, is the system's words.
  Expected<void> open(const Endpoint& end,
                      int waiting = Acceptor::max_listen_connections) {
    typename Asio::Error error;
    acceptor_.open(end.protocol(), error);
    if (!error)
      acceptor_.set_option(typename Acceptor::reuse_address(true), error);
    if (!error)
      acceptor_.bind(end, error);
    if (!error)
      acceptor_.listen(waiting, error);
    if (error)
      return fail(ErrorKind::network, error.message());
    const auto mine = acceptor_.local_endpoint();
    const auto host = mine.address().to_string();
    address_ = (mine.address().is_v6() ? '[' + host + ']' : host) + ':' +
               std::to_string(mine.port());
    return {};
  }

  // Where it listens: "127.0.0.1:4000", "[::1]:4000". It does not change after
  // open().
  const std::string& address() const {
    return address_;
  }

  // Accepts one connection after the other until close().
  void accept(Calls calls) {
    calls_ = std::move(calls);
    go_on();
  }

  // There may be room again. Changes nothing while it accepts or pauses.
  void go_on() {
    if (is_busy_ || !acceptor_.is_open() ||
        (calls_.has_room && !calls_.has_room()))
      return;
    acceptor_.async_accept([this](typename Asio::Error error, Socket socket) {
      // Where it was aborted, this may be gone.
      if (error != Asio::aborted)
        accepted(error, std::move(socket));
    });
    is_busy_ = true;
  }

  void close() {
    typename Asio::Error ignored; // it may never have been open
    acceptor_.close(ignored);
    pause_.cancel();
  }

private:
  static constexpr Milliseconds pause_between{200};

  void accepted(typename Asio::Error error, Socket socket) {
    is_busy_ = false;
    if (!acceptor_.is_open())
      return;
    if (error)
      return accept_later(error.message());
    try {
      calls_.take(std::move(socket));
    } catch (...) {
      go_on();
      throw;
    }
    go_on();
  }

  // While the process has too many files open, accepting fails at once, again
  // and again.
  void accept_later(const std::string& why) {
    is_busy_ = true;
    pause_.expires_after(pause_between);
    pause_.async_wait([this](typename Asio::Error error) {
      if (error)
        return;
      is_busy_ = false;
      go_on();
    });
    if (calls_.failed)
      calls_.failed(why);
  }

  Acceptor acceptor_;
  typename Asio::Timer pause_;
  Calls calls_;
  std::string address_;
  // It accepts or pauses.
  bool is_busy_ = false;
};

} // namespace parlour::adapters
