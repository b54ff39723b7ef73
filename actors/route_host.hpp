// The host of a route's condition: a script that sees one message and nothing
// else (engine rule 1b).
#pragma once

#include "runtime/base/message.hpp"
#include "script/host.hpp"

namespace parlour::actors {

class RouteHost : public script::Host {
public:
  RouteHost(const Message& message, Timestamp now);

  script::Performed perform(script::Activation& activation,
                            script::Effect effect) override;
  Value slot(script::TopicId topic, script::SlotId slot) const override;
  void set_slot(script::TopicId topic, script::SlotId slot,
                Value value) override;
  Value system(const script::Activation& activation,
               script::SystemVariable variable) const override;
  bool online(const std::string& agent) const override;
  Timestamp now() const override;
  double random() override;

private:
  const Message& message_;
  Timestamp now_;
};

} // namespace parlour::actors
