// ServiceServer: a service of the tests' own on the loopback interface, which
// behaves or misbehaves as the test says.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::test {

// What the server does with one request.
struct Reply {
  std::string bytes;
  // What follows: the next request, the end of the connection, or nothing at
  // all until the client gives up.
  enum class Then : std::uint8_t { next, close, nothing } then = Then::next;
};

// A complete answer.
inline Reply reply(int status, const std::string& body = "",
                   const std::string& headers = "") {
  return {"HTTP/1.1 " + std::to_string(status) + " Some\r\n" + headers +
          "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body};
}

class ServiceServer {
public:
  // Gets a whole request, head and body; `number` counts them from 1. Called
  // on a thread of each connection, one call at a time.
  using Behaviour =
      std::function<Reply(const std::string& request, int number)>;

  explicit ServiceServer(Behaviour behaviour)
      : behaviour_(std::move(behaviour)),
        listening_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* raw = reinterpret_cast<sockaddr*>(&address);
    if (bind(listening_, raw, size) != 0 || ::listen(listening_, 64) != 0 ||
        getsockname(listening_, raw, &size) != 0)
      throw std::runtime_error("no port is free");
    port_ = ntohs(address.sin_port);
    accepting_ = std::thread([this] { accept_all(); });
  }
  ServiceServer(const ServiceServer&) = delete;
  ServiceServer& operator=(const ServiceServer&) = delete;
  ~ServiceServer() {
    shutdown(listening_, SHUT_RDWR);
    accepting_.join();
    close(listening_);
    for (auto& one : connections_)
      shutdown(one.socket, SHUT_RDWR);
    for (auto& one : connections_) {
      one.thread.join();
      close(one.socket);
    }
  }

  std::string address() const {
    return "http://127.0.0.1:" + std::to_string(port_);
  }
  std::vector<std::string> requests() {
    const std::lock_guard lock(mutex_);
    return requests_;
  }
  // Blocks until so many requests have come.
  void wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [&] { return requests_.size() >= count; });
  }

private:
  struct Connection {
    int socket;
    std::thread thread = {};
  };

  void accept_all() {
    for (;;) {
      const auto socket = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
      if (socket < 0)
        return;
      auto& one = connections_.emplace_back(Connection{socket});
      one.thread = std::thread([this, socket] { serve(socket); });
    }
  }

  void serve(int socket) {
    std::string text;
    for (;;) {
      const auto request = take_request(socket, text);
      if (request.empty())
        break;
      const auto [bytes, then] = answer(request);
      send_all(socket, bytes);
      if (then == Reply::Then::close)
        break;
      char byte = 0;
      if (then == Reply::Then::nothing && recv(socket, &byte, 1, 0) <= 0)
        break;
    }
    shutdown(socket, SHUT_RDWR);
  }

  Reply answer(const std::string& request) {
    const std::lock_guard lock(mutex_);
    requests_.push_back(request);
    came_.notify_all();
    return behaviour_(request, static_cast<int>(requests_.size()));
  }

  // Empty: the client has closed.
  static std::string take_request(int socket, std::string& text) {
    std::size_t size = 0;
    while ((size = complete(text)) == 0) {
      char buffer[4096];
      const auto got = recv(socket, buffer, sizeof buffer, 0);
      if (got <= 0)
        return {};
      text.append(buffer, static_cast<std::size_t>(got));
    }
    auto request = text.substr(0, size);
    text.erase(0, size);
    return request;
  }
  // The length of the request that the text begins with; 0: it is not all
  // there.
  static std::size_t complete(const std::string& text) {
    const auto end = text.find("\r\n\r\n");
    if (end == std::string::npos)
      return 0;
    const auto at = text.find("Content-Length: ");
    const auto body =
        at < end ? std::stoul(text.substr(at + 16)) : std::size_t{0};
    return text.size() < end + 4 + body ? 0 : end + 4 + body;
  }
  static void send_all(int socket, const std::string& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
      const auto took = ::send(socket, bytes.data() + sent, bytes.size() - sent,
                               MSG_NOSIGNAL);
      if (took <= 0)
        return;
      sent += static_cast<std::size_t>(took);
    }
  }

  const Behaviour behaviour_;
  const int listening_;
  int port_ = 0;
  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<std::string> requests_;
  // Only the accepting thread adds to it, until that has ended.
  std::list<Connection> connections_;
  std::thread accepting_;
};

} // namespace parlour::test
