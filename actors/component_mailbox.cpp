#include "actors/component_mailbox.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <caf/send.hpp>

namespace parlour::actors {

const char* ComponentMailbox::put(Job& job) {
  std::unique_lock lock(mutex_);
  if (closed_)
    return closed_;
  if (waiting_.size() >= capacity)
    return "has more messages waiting than it may";
  waiting_.push_back(std::move(job));
  auto host = one_to_wake();
  lock.unlock();
  wake(host);
  return nullptr;
}

void ComponentMailbox::put_back(Job job) {
  std::unique_lock lock(mutex_);
  waiting_.push_front(std::move(job));
  auto host = one_to_wake();
  lock.unlock();
  wake(host);
}

component_host_actor ComponentMailbox::one_to_wake() {
  if (waiting_.empty() || resting_.empty())
    return {};
  auto host = std::move(resting_.back());
  resting_.pop_back();
  return host;
}

void ComponentMailbox::wake(const component_host_actor& host) {
  if (host)
    caf::anon_send(host, work_waits{});
}

void ComponentMailbox::join(const component_host_actor& host) {
  std::unique_lock lock(mutex_);
  members_.push_back(host);
  resting_.push_back(host);
  auto next = one_to_wake();
  lock.unlock();
  wake(next);
}

// It may have been told of what it will not take: then another is.
void ComponentMailbox::leave(const component_host_actor& host) {
  std::unique_lock lock(mutex_);
  std::erase(members_, host);
  std::erase(resting_, host);
  auto next = one_to_wake();
  lock.unlock();
  wake(next);
}

std::optional<ComponentMailbox::Job>
ComponentMailbox::take(const component_host_actor& host) {
  std::lock_guard lock(mutex_);
  if (std::find(members_.begin(), members_.end(), host) == members_.end())
    return std::nullopt;
  if (waiting_.empty()) {
    resting_.push_back(host);
    return std::nullopt;
  }
  auto job = std::move(waiting_.front());
  waiting_.pop_front();
  return job;
}

bool ComponentMailbox::empty() const {
  std::lock_guard lock(mutex_);
  return waiting_.empty();
}

void ComponentMailbox::close(const char* why) {
  std::lock_guard lock(mutex_);
  closed_ = why;
}

void ComponentMailbox::open() {
  std::lock_guard lock(mutex_);
  closed_ = nullptr;
}

std::vector<ComponentMailbox::Job> ComponentMailbox::take_all() {
  std::lock_guard lock(mutex_);
  std::vector<Job> all(std::make_move_iterator(waiting_.begin()),
                       std::make_move_iterator(waiting_.end()));
  waiting_.clear();
  return all;
}

} // namespace parlour::actors
