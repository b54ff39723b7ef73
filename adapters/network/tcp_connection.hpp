// TcpConnection: one TCP client, from its opening to its end, without waiting
// and without a thread: whoever polls tells it what can be done. Not
// thread-safe.
#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <vector>

#include "adapters/network/address.hpp"
#include "adapters/network/text_framer.hpp"
#include "runtime/base/sockets.hpp"

namespace parlour::adapters {

class TcpConnection {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // Texts that are told and not yet taken.
  static constexpr int most_untaken = 16;
  // Bytes that wait for the other side.
  static constexpr std::size_t most_unsent = 1 << 20;

  TcpConnection(SocketOrder order, Sockets::Tell tell, Moment now);
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;
  ~TcpConnection();

  // Tries one address after the other.
  void connect(std::vector<Endpoint> endpoints);
  // It will not be opened.
  void give_up(const std::string& reason);

  Expected<void> send(const std::string& text);
  void taken();
  // Nothing is told any more; what was sent gets a little time to leave.
  void close(Moment now);

  // What to poll for; -1: nothing.
  int descriptor() const;
  short interest() const; // POLLIN, POLLOUT
  // What can be done now, as poll says it.
  void act(short ready);
  // How long to wait at most, and what to do when that has come.
  Moment deadline() const {
    return deadline_;
  }
  void be_late();
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
  std::vector<Endpoint> endpoints_; // not tried yet, the next one last
  std::string trouble_;             // of the address tried before
  TextFramer framer_;
  std::deque<std::string> texts_; // read, not told
  int untaken_ = 0;
  bool ended_ = false; // nothing more to read; `trouble_` says why
  std::string unsent_;
  Moment deadline_;
};

} // namespace parlour::adapters
