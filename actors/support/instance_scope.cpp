#include "actors/support/instance_scope.hpp"

#include <utility>

namespace parlour::actors {

InstanceScope::InstanceScope(std::string name, SessionId session)
    : name_(std::move(name)), session_(std::move(session)) {}

SessionId InstanceScope::session() const {
  std::lock_guard lock(mutex_);
  return session_;
}

void InstanceScope::begins(const SessionId& session) {
  std::lock_guard lock(mutex_);
  session_ = session;
}

void InstanceScope::is_over(const SessionId& session) {
  std::lock_guard lock(mutex_);
  if (session_ == session)
    session_ = name_;
}

} // namespace parlour::actors
