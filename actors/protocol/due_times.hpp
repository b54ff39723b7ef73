// The times at which something is to happen by itself: timers of sessions,
// deadlines of queries, delays that components asked for. They are no work: the
// node is quiet while they are pending.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "runtime/base/clock.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// Part of NodeTime. Each kind of owner has its own reason to be asked about:
// whether a session's timer is near decides how long a tool waits; whether a
// component's delay is pending, whether a node may call itself quiet.
class DueTimes {
public:
  using Id = std::uint64_t;
  enum class Of : std::uint8_t { session, component };

  struct Entry {
    Id id = 0;
    Timestamp due = 0;
  };

  // `changed` is called after each removal, outside of any lock.
  explicit DueTimes(std::function<void()> changed);

  Id add(Timestamp due, Of of);
  // Fired or cancelled; removing what is not there does nothing.
  void remove(Id id);

  bool has(Id id) const;
  // The earliest; of several at one time the one that was added first.
  std::optional<Entry> next() const;
  // Of those of sessions the earliest.
  std::optional<Timestamp> next_of_sessions() const;
  bool overdue(Timestamp now) const;
  // A component wants to go on by itself.
  bool component_pending() const;

private:
  using InOrder = std::set<std::pair<Timestamp, Id>>;
  struct Pending {
    Timestamp due = 0;
    Of of = Of::session;
  };

  InOrder& in_order(Of of) {
    return in_order_[static_cast<std::size_t>(of)];
  }
  const InOrder& in_order(Of of) const {
    return in_order_[static_cast<std::size_t>(of)];
  }

  std::function<void()> changed_;
  mutable std::mutex mutex_;
  std::unordered_map<Id, Pending> pending_;
  // The same in order, for each Of.
  std::array<InOrder, 2> in_order_;
  Id last_ = 0;
};

// Removes its entry when it goes, whatever way its owner ends.
// Kept by whoever waits for the time: a timer's actor, a query, a message to a
// host. Movable, as a unique pointer is.
class DueTicket {
public:
  DueTicket() = default;
  DueTicket(DueTimes& times, DueTimes::Id id) : times_(&times), id_(id) {}
  DueTicket(DueTicket&& other) noexcept;
  DueTicket& operator=(DueTicket&& other) noexcept;
  ~DueTicket();

  DueTimes::Id id() const {
    return id_;
  }

private:
  DueTimes* times_ = nullptr;
  DueTimes::Id id_ = 0;
};

} // namespace parlour::actors
