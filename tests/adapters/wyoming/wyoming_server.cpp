#include "tests/adapters/wyoming/wyoming_server.hpp"

#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::test {

using adapters::wyoming::Event;

std::optional<Event> WyomingServer::Peer::read() {
  char buffer[4'096];
  while (waiting_.empty()) {
    const auto size = recv(socket_, buffer, sizeof buffer, 0);
    if (size <= 0)
      return std::nullopt;
    auto events = reader_.take({buffer, static_cast<std::size_t>(size)});
    if (!events)
      return std::nullopt;
    waiting_ = std::move(*events);
  }
  auto event = std::move(waiting_.front());
  waiting_.erase(waiting_.begin());
  return event;
}

bool WyomingServer::Peer::write(const std::string& bytes) const {
  for (std::size_t at = 0; at < bytes.size();) {
    const auto size =
        ::send(socket_, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (size <= 0)
      return false;
    at += static_cast<std::size_t>(size);
  }
  return true;
}

bool WyomingServer::Peer::send(const Event& event) const {
  return write(encode(event));
}

void WyomingServer::Peer::wait_for_end() {
  while (read())
    continue;
}

void WyomingServer::Peer::stall() const {
  pollfd waited{socket_, POLLRDHUP, 0};
  while (poll(&waited, 1, -1) == 0)
    continue;
}

struct WyomingServer::State {
  std::string service;
  Serve serve;
  int listener = -1;
  int port = 0;
  std::thread thread;
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::list<int> sockets;
  std::list<std::thread> threads;
  int connections = 0;

  void run() {
    while (true) {
      const int socket = accept(listener, nullptr, nullptr);
      if (socket < 0)
        return;
      const std::lock_guard lock(mutex);
      ++connections;
      changed.notify_all();
      sockets.push_back(socket);
      threads.emplace_back([this, socket] { attend(socket); });
    }
  }

  void attend(int socket) const {
    Peer peer(socket);
    while (const auto event = peer.read())
      if (event->type == "describe" && !service.empty())
        peer.send({"info", {{service, {{{"name", "test"}}}}}});
      else if (!serve(peer, *event))
        break;
    shutdown(socket, SHUT_RDWR);
  }
};

WyomingServer::WyomingServer(std::string service, Serve serve, int port)
    : state_(std::make_unique<State>()) {
  state_->service = std::move(service);
  state_->serve = std::move(serve);
  state_->listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  setsockopt(state_->listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  // Little waits in the system for a server that takes nothing.
  const int little = 64 << 10;
  setsockopt(state_->listener, SOL_SOCKET, SO_RCVBUF, &little, sizeof little);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  socklen_t size = sizeof address;
  if (bind(state_->listener, reinterpret_cast<sockaddr*>(&address), size) ||
      listen(state_->listener, SOMAXCONN))
    std::abort();
  getsockname(state_->listener, reinterpret_cast<sockaddr*>(&address), &size);
  state_->port = ntohs(address.sin_port);
  state_->thread = std::thread([this] { state_->run(); });
}

WyomingServer::~WyomingServer() {
  shutdown(state_->listener, SHUT_RDWR);
  state_->thread.join();
  for (const int socket : state_->sockets)
    shutdown(socket, SHUT_RDWR);
  for (auto& thread : state_->threads)
    thread.join();
  for (const int socket : state_->sockets)
    close(socket);
  close(state_->listener);
}

int WyomingServer::port() const {
  return state_->port;
}

Options WyomingServer::options() const {
  return {{"address", "127.0.0.1:" + std::to_string(port())},
          {"answer-timeout", "300ms"},
          {"pause", "10ms"}};
}

void WyomingServer::wait_for_connections(int count) const {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [&] { return state_->connections >= count; });
}

} // namespace parlour::test
