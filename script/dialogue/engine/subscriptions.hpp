// Subscriptions: what of the events that belong to no session this one wants to
// hear. They end with it.
#pragma once

#include <vector>

#include "runtime/message/subscription.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

class Subscriptions {
public:
  explicit Subscriptions(Port& port) : port_(port) {}

  script::Performed add(const script::Effect& effect);
  script::Performed remove(const script::Effect& effect);
  // Another port is told of them.
  void resume() const {
    if (!all_.empty())
      port_.subscribe(all_);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(port_);
    archive(all_);
  }

private:
  Port& port_;
  std::vector<Subscription> all_;
};

} // namespace parlour::dialogue
