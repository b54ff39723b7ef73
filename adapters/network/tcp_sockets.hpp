// TcpSockets implements the interface Sockets, through which scripts use TCP,
// for all connections of a run. One loop waits for them; it starts with the
// first one.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "adapters/loop/alarm.hpp"
#include "adapters/loop/watch.hpp"
#include "adapters/network/resolver.hpp"
#include "adapters/network/tcp_connection.hpp"
#include "runtime/base/outside/sockets.hpp"

namespace parlour::adapters {

// Thread-safe. A Tell function must not call it: the lock is held. If one
// throws on the loop's thread, its connection is closed.
class TcpSockets : public Sockets {
public:
  TcpSockets();
  // Closes all connections; nothing is reported any more.
  ~TcpSockets() override;

  Id open(SocketOrder order, Tell tell) override;
  Expected<void> send(Id id, const std::string& text) override;
  void taken(Id id) override;
  void close(Id id) override;

private:
  // A connection, and what the loop waits for on its behalf.
  struct Entry;

  Expected<void> start_loop();
  Id add(SocketOrder order, Tell tell);
  void resolved(Id id, const Endpoints& endpoints);
  TcpConnection* find(Id id);
  void changed(Id id);
  void act(Id id, short ready);
  void drop_what_was_at_work();

  // Held while a connection is used and while it reports.
  std::mutex mutex_;
  // Null until the first connection.
  std::unique_ptr<Loop> loop_;
  std::map<Id, std::unique_ptr<Entry>> connections_;
  Id last_ = 0;
  // Which act() has come to last.
  Id at_work_ = 0;
  // The last member, destroyed first: it calls resolved().
  Resolver resolver_;
};

} // namespace parlour::adapters
