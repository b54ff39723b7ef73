#include "adapters/network/resolver.hpp"

#include <cstring>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <netdb.h>
#include <netinet/in.h>

namespace parlour::adapters {

namespace {

// How many names are looked up at the same time; others wait.
constexpr int max_threads = 4;

void start_detached(std::function<void()> work) {
  std::thread(std::move(work)).detach();
}

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

  // With the lock held. Where others run, one of them will take the task.
  void no_thread(const std::string& reason) {
    if (--threads > 0)
      return;
    const auto task = std::move(tasks.back());
    tasks.pop_back();
    task.done(fail(ErrorKind::limit, "no thread can look up the host '" +
                                         task.address.host + "': " + reason));
  }

  // Calls back under the lock, so that nothing is called once the destructor
  // has returned.
  void tell(const Task& task, Endpoints found) {
    std::lock_guard lock(mutex);
    if (!over)
      task.done(std::move(found));
  }
};

Resolver::Resolver() : Resolver(start_detached) {}

Resolver::Resolver(StartThread start_thread)
    : start_thread_(std::move(start_thread)),
      state_(std::make_shared<State>()) {}

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
  try {
    start_thread_([state = state_] {
      for (State::Task task; state->take(task);)
        state->tell(task, resolve_now(task.address));
    });
  } catch (const std::system_error& error) {
    state_->no_thread(error.code().message());
  }
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
