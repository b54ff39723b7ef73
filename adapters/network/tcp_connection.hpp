// TcpConnection is the state machine of one TCP client. It never blocks and has
// no thread: whoever waits tells it what can be done (language rules 11.9 and
// 11.10).
//
//  resolving    the host's name is being looked up
//  connecting   one address after the other is tried
//  open         texts go both ways
//  closing      closed by the script; the last bytes leave
//  over         the socket is closed
#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <vector>

#include "adapters/network/address.hpp"
#include "adapters/network/text_framer.hpp"
#include "runtime/base/outside/sockets.hpp"

namespace parlour::adapters {

// Not thread-safe.
class TcpConnection {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // Flow control: how many texts may be reported and not yet taken. Beyond that
  // the socket is not read, so that TCP slows the sender down.
  static constexpr int max_untaken = 16;
  // How many bytes may wait to be sent. Beyond that, send() fails.
  static constexpr std::size_t max_unsent = 1 << 20;

  // `now` starts the time limit for connecting.
  TcpConnection(SocketOrder order, Sockets::Tell tell, Moment now);
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;
  ~TcpConnection();

  // Tries the addresses one after the other until one accepts.
  void connect(std::vector<Endpoint> endpoints);
  // Reports that the connection cannot be opened.
  void give_up(const std::string& reason);

  // Queues a text; act() writes it. Fails if the connection is not open.
  Expected<void> send(const std::string& text);
  // The receiver has processed one text; the next may be reported.
  void taken();
  // Closes the connection at the script's request. Nothing is reported any
  // more; what was queued gets two seconds to leave.
  void close(Moment now);

  // What to wait for: a descriptor, or -1 for none, and the events POLLIN and
  // POLLOUT. Without an event nothing is to be waited for, not even a hang-up.
  int descriptor() const {
    return socket_;
  }
  short interest() const;
  // Does what poll() says is possible; `ready` is its revents.
  void act(short ready);
  // When be_late() is to be called.
  Moment deadline() const {
    return deadline_;
  }
  // The time limit for connecting or closing has passed.
  void be_late();
  // The descriptor stays the same from now on, until the connection is over.
  bool is_open() const {
    return state_ == State::open || state_ == State::closing;
  }
  bool over() const {
    return state_ == State::over;
  }

private:
  enum class State : std::uint8_t {
    resolving,
    connecting,
    open,
    closing,
    over
  };

  void try_next();
  void connected();
  void read();
  void write();
  void end(const std::string& reason);
  void deliver();
  void finish();

  SocketOrder order_;
  Sockets::Tell tell_;
  State state_ = State::resolving;
  int socket_ = -1;
  // Addresses that were not tried yet, the next one last.
  std::vector<Endpoint> endpoints_;
  // Why the previous address failed, or why the connection ended.
  std::string trouble_;
  TextFramer framer_;
  // Texts that were read and not reported yet.
  std::deque<std::string> texts_;
  int untaken_ = 0;
  // The other side has closed, or an error ended the connection.
  bool ended_ = false;
  std::string unsent_;
  Moment deadline_;
};

} // namespace parlour::adapters
