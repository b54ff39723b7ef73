#include "actors/support/actor_trace.hpp"

namespace parlour::actors {

namespace {

// What has not been routed yet, or to nobody: whether it is private is not
// known (discretion.hpp), so only its name is shown.
bool may_be_private(const std::string& message) {
  return message == "publish" || message == "forward";
}

} // namespace

ActorTrace::ActorTrace(Observer& observer, std::string_view kind,
                       std::string_view name, std::string_view session) {
  if (!observer.traces(kind, name))
    return;
  observer_ = &observer;
  actor_ = name.empty() ? std::string(kind)
                        : std::string(kind) + " " + std::string(name);
  session_ = session;
}

void ActorTrace::took(const std::string& message, std::string detail,
                      const SessionId& session) const {
  if (!observer_)
    return;
  if (may_be_private(message))
    detail.clear();
  Inspection seen;
  seen.kind = InspectionKind::actor;
  seen.session = session_.empty() ? session : session_;
  seen.subject = actor_;
  seen.detail = message + (detail.empty() ? "" : " ") + std::move(detail);
  observer_->inspect(std::move(seen));
}

} // namespace parlour::actors
