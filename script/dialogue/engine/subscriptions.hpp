// Subscriptions: what of the events that belong to no session this one wants to
// hear. They end with it.
#pragma once

#include <vector>

#include "runtime/base/subscription.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

class Subscriptions {
public:
  explicit Subscriptions(Port& port) : port_(port) {}

  script::Performed add(const script::Effect& effect);
  script::Performed remove(const script::Effect& effect);

private:
  Port& port_;
  std::vector<Subscription> all_;
};

} // namespace parlour::dialogue
