#include "actors/route_host.hpp"

namespace parlour::actors {

RouteHost::RouteHost(const Message& message, Timestamp now)
    : message_(message), now_(now) {}

script::Performed RouteHost::perform(script::Activation&, script::Effect) {
  return Error{ErrorKind::refused, "a route's condition can only compute", {}};
}

Value RouteHost::slot(script::TopicId, script::SlotId) const {
  return {};
}

void RouteHost::set_slot(script::TopicId, script::SlotId, Value) {}

Value RouteHost::system(const script::Activation&,
                        script::SystemVariable variable) const {
  if (variable == script::SystemVariable::session)
    return message_.session;
  return {};
}

bool RouteHost::online(const std::string&) const {
  return false;
}

Timestamp RouteHost::now() const {
  return now_;
}

double RouteHost::random() {
  return 0;
}

} // namespace parlour::actors
