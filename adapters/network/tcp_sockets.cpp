#include "adapters/network/tcp_sockets.hpp"

#include <chrono>
#include <utility>

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;

} // namespace

// The watch and the alarm belong to the loop's thread, the connection to
// whoever holds the mutex.
struct TcpSockets::Entry {
  Entry(TcpSockets& sockets, Id id, SocketOrder order, Tell tell)
      : connection(std::move(order), std::move(tell), Steady::now()),
        watch(*sockets.loop_,
              [&sockets, id](short ready) { sockets.act(id, ready); }),
        alarm(*sockets.loop_, [&sockets, id] { sockets.act(id, 0); }) {}

  TcpConnection connection;
  Watch watch;
  Alarm alarm;
};

TcpSockets::TcpSockets() = default;

TcpSockets::~TcpSockets() {
  if (loop_)
    loop_->stop();
  std::lock_guard lock(mutex_);
  connections_.clear();
}

Sockets::Id TcpSockets::open(SocketOrder order, Tell tell) {
  const auto address = parse_address(order.address);
  const auto id = add(std::move(order), std::move(tell));
  // Without our lock: the resolver calls resolved() while it holds its own, so
  // taking the two locks here in the other order could deadlock.
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
  const auto id = ++last_;
  if (auto started = start_loop(); !started) {
    tell({SocketEvent::Kind::failed,
          "no connection is possible: " + started.error().message});
    return id;
  }
  connections_.emplace(id, std::make_unique<Entry>(*this, id, std::move(order),
                                                   std::move(tell)));
  changed(id);
  return id;
}

// The loop is started with the first connection: most runs have none.
Expected<void> TcpSockets::start_loop() {
  if (loop_)
    return {};
  auto started = Loop::start([this](const auto&) { drop_what_was_at_work(); });
  if (!started)
    return tl::make_unexpected(started.error());
  loop_ = std::move(*started);
  return {};
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
  changed(id);
}

TcpConnection* TcpSockets::find(Id id) {
  const auto found = connections_.find(id);
  return found == connections_.end() ? nullptr : &found->second->connection;
}

Expected<void> TcpSockets::send(Id id, const std::string& text) {
  std::lock_guard lock(mutex_);
  auto* connection = find(id);
  if (!connection)
    return fail(ErrorKind::network, "it is closed");
  changed(id);
  return connection->send(text);
}

void TcpSockets::taken(Id id) {
  std::lock_guard lock(mutex_);
  if (auto* connection = find(id)) {
    connection->taken();
    changed(id);
  }
}

void TcpSockets::close(Id id) {
  std::lock_guard lock(mutex_);
  if (auto* connection = find(id)) {
    connection->close(Steady::now());
    changed(id);
  }
}

// Another thread may have closed the connection's socket. What it posts here is
// done before any later socket with that number is waited for.
void TcpSockets::changed(Id id) {
  loop_->post([this, id] { act(id, 0); });
}

// -- on the loop's thread -----------------------------------------------------

// Lets the connection do what it can, and then waits for what it wants next.
void TcpSockets::act(Id id, short ready) {
  std::lock_guard lock(mutex_);
  const auto found = connections_.find(id);
  if (found == connections_.end())
    return;
  at_work_ = id;
  auto& [connection, watch, alarm] = *found->second;
  // While it connects, it may close its socket and open another one.
  if (!connection.is_open())
    watch.stop();
  if (!connection.over())
    connection.act(ready);
  if (!connection.over() && connection.deadline() <= Steady::now())
    connection.be_late();
  if (connection.over()) {
    connections_.erase(found);
    return;
  }
  watch.await(connection.descriptor(), connection.interest());
  alarm.set(connection.deadline());
}

// Nobody knows what the connection would have done next.
void TcpSockets::drop_what_was_at_work() {
  std::lock_guard lock(mutex_);
  connections_.erase(at_work_);
}

} // namespace parlour::adapters
