// SharedTable: the routing table that senders apply, on every thread with each
// message.
#pragma once

#include <array>
#include <atomic>
#include <memory>

#include "actors/routing/routing_table.hpp"

namespace parlour::actors {

// Threads are counted as they come here.
std::size_t number_of_thread();

// Safe to use from any thread. Each of some threads has a pointer with a count
// of its own: were there one, every message would wait for a cache line that
// another thread has just written.
template <class What>
class SharedByThreads {
public:
  using Pointer = std::shared_ptr<const What>;

  // For who stores one after the other. A thread sees each in its turn; while
  // one is stored, some see it earlier than others.
  //
  // Each copy is a pointer with a holder of its own, so that threads count in
  // different places, but all of them point to the same object.
  void store(const Pointer& what) {
    for (auto& copy : copies_) {
      const auto holder = std::make_shared<const Holder>(Holder{what});
      copy.what.store(Pointer(holder, holder->what.get()));
    }
  }
  // Null before the first one.
  Pointer load() const {
    return copies_[number_of_thread() % copies_.size()].what.load();
  }

private:
  static constexpr std::size_t cache_line = 64;
  struct alignas(cache_line) Holder {
    Pointer what;
  };
  struct alignas(cache_line) Copy {
    std::atomic<Pointer> what;
  };
  // More threads than that share copies, which is slower and nothing else.
  std::array<Copy, 16> copies_;
};

using SharedTable = SharedByThreads<RoutingTable>;

} // namespace parlour::actors
