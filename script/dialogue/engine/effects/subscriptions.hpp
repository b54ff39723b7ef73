// Subscriptions: what of the events that belong to no session this one wants to
// hear. They end with it.
#pragma once

#include <vector>

#include "runtime/message/subscription.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// A part of OutsideEffects (engine rule 1d, language rule 12.15). The port is
// told the whole list after each change.
class Subscriptions {
public:
  explicit Subscriptions(Port& port) : port_(port) {}

  // Refused: a source of the platform, and more than a session may have. What
  // is subscribed already changes nothing.
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
