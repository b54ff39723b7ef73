// Resolver looks up host names without blocking its caller. The system's
// function getaddrinfo may block for many seconds and cannot be interrupted, so
// it runs on a few detached threads. Destroying the resolver does not wait for
// them.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "adapters/network/address.hpp"

namespace parlour::adapters {

using Endpoints = Expected<std::vector<Endpoint>>;

// Thread-safe. Lookups that are under way when the resolver is destroyed are
// forgotten.
class Resolver {
public:
  using Done = std::function<void(Endpoints)>;
  // Runs it on a thread that nobody waits for. Throws std::system_error where
  // the system has none left.
  using StartThread = std::function<void(std::function<void()>)>;

  Resolver();
  explicit Resolver(StartThread start_thread);
  Resolver(const Resolver&) = delete;
  Resolver& operator=(const Resolver&) = delete;
  ~Resolver();

  // Calls `done` once, from another thread, unless the resolver is destroyed
  // first; where no thread can be started it is called at once, with an error
  // of the kind `limit`. `done` must not call the resolver, whose lock is held.
  void resolve(Address address, Done done);

private:
  struct State;
  const StartThread start_thread_;
  std::shared_ptr<State> state_;
};

// Looks up a name on the calling thread, and blocks.
Endpoints resolve_now(const Address& address);

} // namespace parlour::adapters
