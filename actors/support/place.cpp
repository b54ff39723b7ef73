#include "actors/support/place.hpp"

#include <utility>

namespace parlour::actors {

Place::Place(std::string name, SessionId session)
    : name_(std::move(name)), session_(std::move(session)) {}

SessionId Place::session() const {
  std::lock_guard lock(mutex_);
  return session_;
}

void Place::begins(const SessionId& session) {
  std::lock_guard lock(mutex_);
  session_ = session;
}

void Place::is_over(const SessionId& session) {
  std::lock_guard lock(mutex_);
  if (session_ == session)
    session_ = name_;
}

} // namespace parlour::actors
