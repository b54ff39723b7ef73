#include "adapters/network/resolver.hpp"

#include <cstring>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include <netdb.h>
#include <netinet/in.h>

namespace parlour::adapters {

namespace {

// How many names are looked up at the same time; others wait.
constexpr int max_threads = 4;

} // namespace

// Shared with the threads: it lives until the last of them has returned from
// the system, which may be long after the resolver.
struct Resolver::State {
  struct Task {
    Address address;
    Done done;
  };

  std::mutex mutex;
  std::deque<Task> tasks;
  int threads = 0;
  bool over = false;

  // The next task for a thread. A thread without one ends.
  bool take(Task& task) {
    std::lock_guard lock(mutex);
    if (over || tasks.empty()) {
      --threads;
      return false;
    }
    task = std::move(tasks.front());
    tasks.pop_front();
    return true;
  }

  // Calls back under the lock, so that nothing is called once the destructor
  // has returned.
  void tell(const Task& task, Endpoints found) {
    std::lock_guard lock(mutex);
    if (!over)
      task.done(std::move(found));
  }
};

Resolver::Resolver() : state_(std::make_shared<State>()) {}

Resolver::~Resolver() {
  std::lock_guard lock(state_->mutex);
  state_->over = true;
  state_->tasks.clear();
}

void Resolver::resolve(Address address, Done done) {
  std::lock_guard lock(state_->mutex);
  state_->tasks.push_back({std::move(address), std::move(done)});
  if (state_->threads >= max_threads)
    return;
  // Threads are started on demand and end when there is no task for them.
  ++state_->threads;
  std::thread([state = state_] {
    for (State::Task task; state->take(task);)
      state->tell(task, resolve_now(task.address));
  }).detach();
}

// AF_UNSPEC asks for IPv4 and IPv6 addresses; the system sorts them.
Endpoints resolve_now(const Address& address) {
  addrinfo wanted{};
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const auto status =
      getaddrinfo(address.host.c_str(), address.port.c_str(), &wanted, &found);
  if (status != 0)
    return fail(ErrorKind::network,
                "the host '" + address.host +
                    "' is not found: " + gai_strerror(status));
  std::vector<Endpoint> endpoints;
  for (const auto* each = found; each; each = each->ai_next) {
    Endpoint endpoint;
    std::memcpy(&endpoint.address, each->ai_addr, each->ai_addrlen);
    endpoint.size = each->ai_addrlen;
    endpoints.push_back(endpoint);
  }
  freeaddrinfo(found);
  return endpoints;
}

} // namespace parlour::adapters
