// TcpSockets: all TCP clients of a run, polled by one thread, which starts with
// the first of them.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "adapters/network/resolver.hpp"
#include "adapters/network/tcp_connection.hpp"
#include "runtime/base/sockets.hpp"

namespace parlour::adapters {

// Safe to use from any thread, but not from within a Tell.
class TcpSockets : public Sockets {
public:
  TcpSockets();
  ~TcpSockets() override; // closes all; nothing is told any more

  Id open(SocketOrder order, Tell tell) override;
  Expected<void> send(Id id, const std::string& text) override;
  void taken(Id id) override;
  void close(Id id) override;

private:
  using Connections = std::map<Id, std::unique_ptr<TcpConnection>>;
  struct Polled;

  Id add(SocketOrder order, Tell tell);
  void resolved(Id id, const Endpoints& endpoints);
  TcpConnection* find(Id id);
  void work();
  void prepare(Polled& polled);
  void act(const Polled& polled);
  void wake();

  // Held while a connection is touched and while it tells; not while the thread
  // sleeps.
  std::mutex mutex_;
  Connections connections_;
  Id last_ = 0;
  bool over_ = false;
  int wake_read_ = -1; // a pipe that ends the thread's sleep
  int wake_write_ = -1;
  std::thread thread_;
  Resolver resolver_; // first to go
};

} // namespace parlour::adapters
