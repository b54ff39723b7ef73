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

// Names looked up at the same time; others wait for their turn.
constexpr int most_threads = 4;

} // namespace

// Outlives the resolver as long as a thread hangs in the system.
struct Resolver::State {
  struct Task {
    Address address;
    Done done;
  };

  std::mutex mutex;
  std::deque<Task> tasks;
  int threads = 0;
  bool over = false;

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

  // Under the lock, so that nothing is told once the resolver has gone.
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
  if (state_->threads >= most_threads)
    return;
  ++state_->threads;
  std::thread([state = state_] {
    for (State::Task task; state->take(task);)
      state->tell(task, resolve_now(task.address));
  }).detach();
}

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
