// Reloader: takes a running node over to a changed application (engine rule
// 7.13).
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "actors/components/instance/plugin_environment.hpp"
#include "actors/node/changed_application.hpp"
#include "actors/node/node_questions.hpp"
#include "actors/protocol/interfaces.hpp"
#include "actors/routing/message_bus.hpp"

namespace parlour::actors {

// First the components, as one that does not start must leave all as it was;
// then the routes, then the conversations.
class Reloader {
public:
  // What is referred to belongs to the node, which outlives this.
  struct Parts {
    NodeQuestions questions;
    NodeTime& time;
    MessageBus& bus;
    const SharedEnvironment& environment;
    supervisor_actor supervisor;
    session_manager_actor manager;
  };
  // `first`: what the node was started with.
  Reloader(Parts parts, ChangedApplication first);

  // As Node says.
  Expected<ReloadOutcome> reload(ChangedApplication to, ReloadMode mode);

private:
  // A plug-in by the name of the component that it was loaded as.
  using Readers = std::map<std::string, std::string>;

  template <class What>
  Expected<void> order(What what) {
    return parts_.questions.order(parts_.supervisor, std::move(what));
  }
  Expected<Readers> change_environment(SharedEnvironment::Pointer to);
  // One component of the settings; its name goes to `loaded`.
  Expected<void> load(const ComponentOrder& order,
                      std::vector<std::string>& loaded);
  Expected<void> load_changed(const ChangedApplication& to,
                              const Readers& readers,
                              std::vector<std::string>& loaded);
  // What was loaded is as before.
  void take_back(const SharedEnvironment::Pointer& environment,
                 const std::vector<std::string>& loaded);

  const Parts parts_;
  std::mutex mutex_; // one change at a time
  ChangedApplication current_;
};

// Components start in the order of these numbers: those that others read from
// when they start come first. Those of seats come last, as a conversation may
// open as soon as one of them hears somebody.
int phase_of_start(const ComponentOrder& order);

} // namespace parlour::actors
