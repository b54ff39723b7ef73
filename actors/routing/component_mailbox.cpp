#include "actors/routing/component_mailbox.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include <caf/send.hpp>

namespace parlour::actors {

// `job` is moved from only where it is taken: the caller answers for it
// otherwise.
const char* ComponentMailbox::put(Job& job) {
  std::unique_lock lock(back_.mutex);
  if (back_.closed)
    return back_.closed;
  if (is_full())
    return "has more messages waiting than it may";
  back_.waiting.push_back(std::move(job));
  back_.received.add();
  auto host = one_to_wake();
  lock.unlock();
  wake(host);
  return nullptr;
}

// Of both queues. The front's size is looked at only where it matters: it is on
// the hosts' cache line.
// `moved` is what the front had when it was filled last. Unless a job was put
// back, it has no more than that, so the first comparison mostly decides.
bool ComponentMailbox::is_full() const {
  const auto waiting = back_.waiting.size();
  return waiting + back_.moved >= capacity && waiting + front_.size >= capacity;
}

// In front: it is older than all that waits. It may exceed the capacity by one,
// as a message that was accepted is not refused later.
void ComponentMailbox::put_back(Job job) {
  std::unique_lock lock(front_.mutex);
  front_.waiting.push_front(std::move(job));
  ++front_.size;
  wake_for_what_waits(std::move(lock));
}

// -- who is told --------------------------------------------------------------

// An idle host, to be told outside of the locks; null: none.
// The one that went idle last.
component_host_actor ComponentMailbox::one_to_wake() {
  if (back_.idle.empty())
    return {};
  auto host = std::move(back_.idle.back());
  back_.idle.pop_back();
  return host;
}

void ComponentMailbox::wake_for_what_waits(Lock front) {
  std::unique_lock lock(back_.mutex);
  const bool waits = !front_.waiting.empty() || !back_.waiting.empty();
  auto host = waits ? one_to_wake() : component_host_actor();
  lock.unlock();
  front.unlock();
  wake(host);
}

void ComponentMailbox::wake(const component_host_actor& host) {
  if (host)
    caf::anon_send(host, mailbox_ready{});
}

void ComponentMailbox::add_worker(const component_host_actor& host) {
  std::unique_lock lock(front_.mutex);
  assert(std::ranges::count(front_.workers, host) == 0 &&
         "it works here already");
  front_.workers.push_back(host);
  {
    std::lock_guard back(back_.mutex);
    back_.idle.push_back(host);
  }
  wake_for_what_waits(std::move(lock));
}

// It may have been told of what it will not take: then another is.
void ComponentMailbox::remove_worker(const component_host_actor& host) {
  std::unique_lock lock(front_.mutex);
  std::erase(front_.workers, host);
  {
    std::lock_guard back(back_.mutex);
    std::erase(back_.idle, host);
  }
  wake_for_what_waits(std::move(lock));
}

// -- taking -------------------------------------------------------------------

// A host that was removed meanwhile gets nothing: its instance is about to
// stop, or was given up.
std::optional<ComponentMailbox::Job>
ComponentMailbox::take(const component_host_actor& host, IfEmpty then) {
  std::lock_guard lock(front_.mutex);
  const auto& workers = front_.workers;
  if (std::find(workers.begin(), workers.end(), host) == workers.end())
    return std::nullopt;
  if (front_.waiting.empty())
    bring_forward(host, then);
  if (front_.waiting.empty())
    return std::nullopt;
  auto job = std::move(front_.waiting.front());
  front_.waiting.pop_front();
  --front_.size;
  return job;
}

// What has arrived; where nothing has, the host may go idle.
// Both happen under the back's lock: a sender that comes later sees the idle
// host and wakes it.
void ComponentMailbox::bring_forward(const component_host_actor& host,
                                     IfEmpty then) {
  std::lock_guard lock(back_.mutex);
  front_.waiting.swap(back_.waiting);
  front_.size = back_.moved = front_.waiting.size();
  if (front_.waiting.empty() && then == IfEmpty::go_idle)
    back_.idle.push_back(host);
}

bool ComponentMailbox::empty() const {
  std::scoped_lock lock(front_.mutex, back_.mutex);
  return front_.waiting.empty() && back_.waiting.empty();
}

std::size_t ComponentMailbox::size() const {
  std::scoped_lock lock(front_.mutex, back_.mutex);
  return front_.waiting.size() + back_.waiting.size();
}

void ComponentMailbox::close(const char* why) {
  std::lock_guard lock(back_.mutex);
  back_.closed = why;
}

void ComponentMailbox::open() {
  std::lock_guard lock(back_.mutex);
  back_.closed = nullptr;
}

std::vector<ComponentMailbox::Job> ComponentMailbox::take_all() {
  std::scoped_lock lock(front_.mutex, back_.mutex);
  std::vector<Job> all;
  for (auto* waiting : {&front_.waiting, &back_.waiting}) {
    std::move(waiting->begin(), waiting->end(), std::back_inserter(all));
    waiting->clear();
  }
  front_.size = back_.moved = 0;
  return all;
}

} // namespace parlour::actors
