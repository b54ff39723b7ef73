// Component: a name, what it runs, and a mailbox; it outlives its instances.
// Instance: one object of its plug-in, with an actor around it
// (component_host). The host's actor, the supervisor and, for inline calls, the
// routing table share an instance.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "actors/components/instance/component_context.hpp"
#include "actors/protocol/component_order.hpp"
#include "actors/support/call_watchdog.hpp"

namespace parlour::actors {

// A component is one name in one scope: that of a seat or session is another
// Component with another mailbox, of the same order.
class Component {
public:
  ComponentOrder order;
  std::shared_ptr<ComponentMailbox> mailbox;
  // Whether messages go to it: it serves, and says that it can take them.
  // Shared with the table, which reads it on other threads.
  std::shared_ptr<std::atomic<bool>> up =
      std::make_shared<std::atomic<bool>>(false);

  // It has started, and is not down.
  void set_serving(bool is_serving) {
    serving_ = is_serving;
    *up = serving_ && available_;
  }
  // What its plug-in says of itself (PluginHost::available).
  void set_available(bool is_available) {
    available_ = is_available;
    *up = serving_ && available_;
  }

  const std::string& name() const {
    return order.name;
  }
  // The limit of one call. Supervision::load has put it into the order.
  Milliseconds deadline() const {
    return order.policy.deadline.value_or(defaults::component_deadline);
  }
  const PluginDescription& description() const {
    return order.factory.description;
  }

private:
  // Of the supervisor's thread.
  bool serving_ = false;
  bool available_ = true;
};

// The supervisor makes it, its host fills `plugin` in, and a session that calls
// it inline may be the last to let go of it.
struct Instance {
  InstanceId id = 0;
  std::shared_ptr<const Component> component;
  std::shared_ptr<ComponentContext> context; // before the plug-in: outlives it
  std::shared_ptr<IPlugin> plugin;           // made by its host, on its thread
  CallWatchdog watch;
  std::string last_error; // of the one before it; set before it starts
  // It drains: its host reports when it has nothing left to do.
  std::atomic<bool> draining = false;
};

} // namespace parlour::actors
