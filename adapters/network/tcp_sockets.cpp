#include "adapters/network/tcp_sockets.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;

// As poll wants it: rounded up, -1 for ever.
int milliseconds_until(TcpConnection::Moment moment) {
  if (moment == TcpConnection::Moment::max())
    return -1;
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(moment - Steady::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 60'000));
}

} // namespace

// What one sleep of the thread waits for.
struct TcpSockets::Polled {
  std::vector<pollfd> descriptors; // the pipe's, then those of `ids`
  std::vector<Id> ids;
  TcpConnection::Moment deadline = TcpConnection::Moment::max();
};

TcpSockets::TcpSockets() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) == 0) {
    wake_read_ = ends[0];
    wake_write_ = ends[1];
  }
}

TcpSockets::~TcpSockets() {
  {
    std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake();
  if (thread_.joinable())
    thread_.join();
  ::close(wake_read_);
  ::close(wake_write_);
}

Sockets::Id TcpSockets::open(SocketOrder order, Tell tell) {
  const auto address = parse_address(order.address);
  const auto id = add(std::move(order), std::move(tell));
  // Not under the lock: the resolver calls back under its own.
  if (address)
    resolver_.resolve(*address, [this, id](const Endpoints& endpoints) {
      resolved(id, endpoints);
    });
  else
    resolved(id, tl::make_unexpected(address.error()));
  return id;
}

Sockets::Id TcpSockets::add(SocketOrder order, Tell tell) {
  std::lock_guard lock(mutex_);
  if (!thread_.joinable())
    thread_ = std::thread([this] { work(); });
  connections_.emplace(
      ++last_, std::make_unique<TcpConnection>(std::move(order),
                                               std::move(tell), Steady::now()));
  return last_;
}

void TcpSockets::resolved(Id id, const Endpoints& endpoints) {
  std::lock_guard lock(mutex_);
  auto* connection = find(id);
  if (!connection)
    return;
  if (endpoints)
    connection->connect(*endpoints);
  else
    connection->give_up(endpoints.error().message);
  wake();
}

TcpConnection* TcpSockets::find(Id id) {
  const auto found = connections_.find(id);
  return found == connections_.end() ? nullptr : found->second.get();
}

Expected<void> TcpSockets::send(Id id, const std::string& text) {
  std::lock_guard lock(mutex_);
  auto* connection = find(id);
  if (!connection)
    return fail(ErrorKind::network, "it is closed");
  wake();
  return connection->send(text);
}

void TcpSockets::taken(Id id) {
  std::lock_guard lock(mutex_);
  if (auto* connection = find(id))
    connection->taken();
  wake();
}

void TcpSockets::close(Id id) {
  std::lock_guard lock(mutex_);
  if (auto* connection = find(id))
    connection->close(Steady::now());
  wake();
}

// -- the thread ---------------------------------------------------------------

void TcpSockets::wake() {
  const char byte = 0;
  // A full pipe wakes as well.
  (void)!write(wake_write_, &byte, 1);
}

void TcpSockets::work() {
  std::unique_lock lock(mutex_);
  while (!over_) {
    Polled polled;
    prepare(polled);
    lock.unlock();
    poll(polled.descriptors.data(), polled.descriptors.size(),
         milliseconds_until(polled.deadline));
    lock.lock();
    act(polled);
  }
  connections_.clear();
}

void TcpSockets::prepare(Polled& polled) {
  std::erase_if(connections_,
                [](const auto& entry) { return entry.second->over(); });
  polled.descriptors.push_back({wake_read_, POLLIN, 0});
  for (const auto& [id, connection] : connections_) {
    polled.deadline = std::min(polled.deadline, connection->deadline());
    polled.descriptors.push_back(
        {connection->descriptor(), connection->interest(), 0});
    polled.ids.push_back(id);
  }
}

void TcpSockets::act(const Polled& polled) {
  char bytes[256];
  while (read(wake_read_, bytes, sizeof bytes) > 0) {
  }
  const auto now = Steady::now();
  for (std::size_t i = 0; i < polled.ids.size() && !over_; ++i) {
    auto* connection = find(polled.ids[i]);
    if (!connection || connection->over())
      continue;
    if (connection->descriptor() == polled.descriptors[i + 1].fd)
      connection->act(polled.descriptors[i + 1].revents);
    if (!connection->over() && connection->deadline() <= now)
      connection->be_late();
  }
}

} // namespace parlour::adapters
