// The host of a route's condition: a script that sees one message and nothing
// else (engine rule 1b).
#pragma once

#include "runtime/message/message.hpp"
#include "script/program/computing_host.hpp"

namespace parlour::actors {

class RouteHost : public script::ComputingHost {
public:
  RouteHost(const Message& message, Timestamp now)
      : ComputingHost("a route's condition", now), message_(message) {}

  Value system(const script::Activation&,
               script::SystemVariable variable) const override {
    if (variable == script::SystemVariable::session)
      return message_.session;
    return {};
  }

private:
  const Message& message_;
};

} // namespace parlour::actors
