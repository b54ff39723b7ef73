// Resolver: names of hosts to addresses. The system's function blocks, for many
// seconds where no name server answers, and cannot be ended: so it runs on a
// few threads that nobody waits for.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "adapters/network/address.hpp"

namespace parlour::adapters {

using Endpoints = Expected<std::vector<Endpoint>>;

// Safe to use from any thread. What is under way when it goes is forgotten.
class Resolver {
public:
  using Done = std::function<void(Endpoints)>;

  Resolver();
  Resolver(const Resolver&) = delete;
  Resolver& operator=(const Resolver&) = delete;
  ~Resolver();

  // Calls `done` from another thread, once, unless this is gone by then.
  void resolve(Address address, Done done);

private:
  struct State;
  std::shared_ptr<State> state_;
};

// The same at once, blocking.
Endpoints resolve_now(const Address& address);

} // namespace parlour::adapters
