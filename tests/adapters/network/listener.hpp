// Listener: a TCP server on the loopback interface with a free port. The test
// drives it; all calls block.
#pragma once

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::test {

class Listener {
public:
  explicit Listener(int buffer = 0)
      : listening_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (buffer > 0)
      setsockopt(listening_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* raw = reinterpret_cast<sockaddr*>(&address);
    if (bind(listening_, raw, size) != 0 || ::listen(listening_, 8) != 0 ||
        getsockname(listening_, raw, &size) != 0)
      throw std::runtime_error("no port is free");
    port_ = ntohs(address.sin_port);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener() {
    hang_up();
    for (auto client : before_)
      close(client);
    close(listening_);
  }

  std::string address() const {
    return "127.0.0.1:" + std::to_string(port_);
  }
  // Accepts the next client; earlier ones stay connected.
  void accept() {
    if (connected_ >= 0)
      before_.push_back(connected_);
    connected_ = ::accept(listening_, nullptr, nullptr);
  }
  // Blocks until so many bytes have come or the other side has closed.
  std::string receive(std::size_t bytes) {
    std::string text(bytes, '\0');
    std::size_t have = 0;
    while (have < bytes) {
      const auto got = recv(connected_, text.data() + have, bytes - have, 0);
      if (got <= 0)
        break;
      have += static_cast<std::size_t>(got);
    }
    text.resize(have);
    return text;
  }
  // What comes within this time; empty: nothing.
  std::string receive_within(std::chrono::milliseconds time) {
    pollfd waits{connected_, POLLIN, 0};
    if (poll(&waits, 1, static_cast<int>(time.count())) <= 0)
      return {};
    std::string text(4'096, '\0');
    const auto got = recv(connected_, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return text;
  }
  void send(const std::string& text) {
    (void)!::send(connected_, text.data(), text.size(), MSG_NOSIGNAL);
  }
  // Sends until the other side's buffers are full; returns how many bytes that
  // took.
  std::size_t fill(std::size_t at_most) {
    const std::string text(64 << 10, '\n');
    std::size_t sent = 0;
    while (sent < at_most) {
      const auto took = ::send(connected_, text.data(), text.size(),
                               MSG_NOSIGNAL | MSG_DONTWAIT);
      if (took < 0)
        break;
      sent += static_cast<std::size_t>(took);
    }
    return sent;
  }
  void hang_up() {
    if (connected_ >= 0)
      close(connected_);
    connected_ = -1;
  }
  // Closes the connection with a reset.
  void break_off() {
    const linger now{1, 0};
    setsockopt(connected_, SOL_SOCKET, SO_LINGER, &now, sizeof now);
    hang_up();
  }

private:
  int listening_;
  int connected_ = -1;
  std::vector<int> before_;
  int port_ = 0;
};

} // namespace parlour::test
