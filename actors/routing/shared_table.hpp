// SharedTable: the routing table that senders apply, on every thread with each
// message.
#pragma once

#include <array>
#include <atomic>
#include <memory>

#include "actors/routing/routing_table.hpp"

namespace parlour::actors {

// Safe to use from any thread. Each of some threads has a pointer with a count
// of its own: were there one, every message would wait for a cache line that
// another thread has just written.
class SharedTable {
public:
  using Pointer = std::shared_ptr<const RoutingTable>;

  // For who stores one after the other. A thread sees each table in its turn;
  // while one is stored, some see it earlier than others.
  void store(const Pointer& table);
  // Null before the first one, and when the node is down.
  Pointer load() const;

private:
  static constexpr std::size_t cache_line = 64;
  struct alignas(cache_line) Holder {
    Pointer table;
  };
  struct alignas(cache_line) Copy {
    std::atomic<Pointer> table;
  };
  std::array<Copy, 16> copies_;
};

} // namespace parlour::actors
