// NodeRuntime: a node's actors, brought up and down in order. What node.hpp
// hides.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <caf/actor_system.hpp>
#include <caf/actor_system_config.hpp>

#include "actors/components/instance/plugin_environment.hpp"
#include "actors/components/supervision.hpp"
#include "actors/node/node_options.hpp"
#include "actors/node/node_questions.hpp"
#include "actors/node/reloader.hpp"
#include "actors/node/scheduler.hpp"
#include "actors/node/status_collector.hpp"
#include "actors/routing/message_bus.hpp"
#include "actors/routing/session_directory.hpp"
#include "actors/sessions/seat.hpp"
#include "actors/sessions/session_parts.hpp"
#include "actors/support/id_source.hpp"
#include "runtime/base/text/text_map.hpp"

namespace parlour::actors {

// Owned by Node; the driving thread calls it, unless a function says otherwise.
// It is the only place that knows all actors.
class NodeRuntime {
public:
  explicit NodeRuntime(NodeOptions options);
  ~NodeRuntime();

  // Starts the components in order; an error stops those that are up.
  Expected<void> start_components();
  // While it runs; both return when it is done, or with an error as
  // NodeQuestions says.
  Expected<void> load(const std::string& plugin, const std::string& name);
  Expected<void> unload(const std::string& name);
  // From any thread in real time, until stop() is called.
  Reloader& reloader() {
    return *reloader_;
  }
  seat_actor open_seat(const std::string& name, SeatCalls calls);
  // With `saved`: one that goes on. It has begun when this returns.
  SessionId
  open_session(const seat_actor& seat,
               std::shared_ptr<const dialogue::SavedSession> saved = nullptr);
  // Seats that come and go. From any thread; nobody waits.
  void begin_visit(const std::string& name, SeatCalls calls,
                   std::shared_ptr<const dialogue::SavedSession> saved);
  void end_visit(const std::string& name);
  // As Node says.
  Value slot_value(const SessionId& session, const std::string& topic,
                   const std::string& slot);
  std::string state_of(const SessionId& session);
  // One, or for an empty id every one.
  void end_session(const SessionId& session);
  // How all actors are; who does not answer within `patience` (real time) is
  // told as such. In real time from any thread, until stop() is called.
  std::vector<ActorStatus> status(Milliseconds patience);
  // As Node says.
  Metrics metrics(Milliseconds patience);
  // Sessions, then components, then the rest, each for at most the drain time;
  // safe to call again. False where something does not come to an end: this
  // node may then never be destroyed.
  bool stop();

  NodeTime& time() {
    return time_;
  }
  Observer& observer() {
    return observer_;
  }
  const SessionDirectory& sessions() const {
    return sessions_;
  }
  MessageBus& bus() {
    return bus_;
  }
  Scheduler& scheduler() {
    return *scheduler_;
  }

private:
  Observer::Watcher watcher();
  SupervisionParts supervision_parts();
  SessionParts session_parts();
  void spawn_actors();
  // Of the components: places in the order of preference.
  std::vector<std::size_t> in_starting_order() const;
  Expected<void> start(std::size_t rank);
  NodeQuestions questions() {
    return {*system_, *scheduler_, time_};
  }
  void stop_sessions();
  void stop_components();
  // Ends those that are left, and forgets their handles.
  void stop_actors();
  // Whom `parlour status` lists; children are asked of the sessions.
  std::vector<ActorHandle> actors() const;
  // Those of which there is one.
  std::vector<ActorHandle> central_actors() const;
  std::vector<ActorStatus> ask_all(const std::vector<ActorHandle>& whom,
                                   Milliseconds patience, Children children);
  // "Weather, City": those that keep the node from ending; "something" where
  // none can be named.
  std::string who_is_at_work();

  // In the order of their making: what is below may use what is above.
  NodeOptions options_;
  std::unique_ptr<Scheduler> scheduler_;
  IdSource ids_;
  NodeTime time_;
  Observer observer_;
  SessionDirectory sessions_;
  InstanceDirectory instances_;
  SharedEnvironment plugin_environment_;
  MessageBus bus_;
  caf::actor_system_config config_;
  std::unique_ptr<caf::actor_system> system_;
  message_centre_actor centre_;
  session_manager_actor manager_;
  supervisor_actor supervisor_;
  file_keeper_actor file_keeper_;
  std::unique_ptr<Reloader> reloader_; // until it stops
  // By name, and the manager's handle: other threads may ask how they are, and
  // visit.
  mutable std::mutex seats_mutex_;
  TextMap<seat_actor> seats_;
};

} // namespace parlour::actors
