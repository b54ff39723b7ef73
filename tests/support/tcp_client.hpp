// Sends bytes to a server on the loopback interface and returns what comes back
// until the server closes.
#pragma once

#include <string>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::test {

class Client {
public:
  // "http://127.0.0.1:PORT", or without the scheme.
  explicit Client(const std::string& address)
      : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<std::uint16_t>(
        std::stoi(address.substr(address.rfind(':') + 1))));
    is_connected_ =
        connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0;
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() {
    close();
  }

  bool is_connected() const {
    return is_connected_;
  }
  void send(const std::string& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
      const auto took = ::send(socket_, bytes.data() + sent,
                               bytes.size() - sent, MSG_NOSIGNAL);
      if (took <= 0)
        return;
      sent += static_cast<std::size_t>(took);
    }
  }
  void close() {
    if (socket_ >= 0)
      ::close(std::exchange(socket_, -1));
  }
  // Sends nothing more.
  void shut() {
    shutdown(socket_, SHUT_WR);
  }
  // Waits for something; empty at the end.
  std::string receive_some() {
    char buffer[1024];
    const auto got = recv(socket_, buffer, sizeof buffer, 0);
    return got <= 0 ? std::string()
                    : std::string(buffer, static_cast<std::size_t>(got));
  }
  std::string receive_all() {
    std::string text;
    for (;;) {
      const auto more = receive_some();
      if (more.empty())
        return text;
      text += more;
    }
  }
  // The status of the answer; 0: there is none.
  int status() {
    const auto text = receive_all();
    return text.size() > 12 ? std::stoi(text.substr(9, 3)) : 0;
  }

private:
  int socket_;
  bool is_connected_ = false;
};

// A POST with this body.
inline std::string post(const std::string& target, const std::string& body,
                        const std::string& headers = "") {
  return "POST " + target + " HTTP/1.1\r\nHost: x\r\n" + headers +
         "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

} // namespace parlour::test
