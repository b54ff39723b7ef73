// Services: what the actors of one node share. Made by the node, which
// outlives its actors; immutable or safe to use from any thread once the node
// has started.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "actors/protocol/interfaces.hpp"
#include "actors/routing/instance_directory.hpp"
#include "actors/routing/query_claims.hpp"
#include "actors/routing/routing_table.hpp"
#include "actors/routing/session_directory.hpp"
#include "actors/routing/shared_table.hpp"
#include "actors/support/node_time.hpp"
#include "actors/support/observer.hpp"
#include "runtime/base/phrases.hpp"
#include "runtime/plugin/catalogue.hpp"

namespace parlour::actors {

struct Services {
  Services(const Clock& clock, ThreadGate::Kind kind, Observer::Watcher watcher)
      : time(clock, kind), observer(std::move(watcher), time.left_behind) {}
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

  NodeTime time;
  Observer observer;
  SessionDirectory sessions;
  QueryClaims claims;
  std::shared_ptr<Counters> counters = std::make_shared<Counters>();

  std::shared_ptr<const script::Program> program;
  std::shared_ptr<const PhraseEvaluator> phrases;
  std::shared_ptr<const UnderstandingModel> understanding;
  ColumnReader columns;
  std::string data_folder;
  std::string application_folder;
  // Components get threads of their own.
  bool detaches = false;
  // What scripts can load; may be empty.
  std::shared_ptr<PluginCatalogue> plugins;
  std::function<void(ComponentOrder&)> complete; // may be empty
  InstanceDirectory instances;
  // Both may be empty: then scripts have none.
  FileAccess files;
  std::shared_ptr<Sockets> sockets;

  // How long a component may take to start, in real time.
  Milliseconds start_time{30'000};
  // The next session's id and seed; called by the session manager only.
  std::function<SessionId()> new_session_id;
  std::function<std::uint64_t()> new_seed;

  // What every table has in common; its targets are the supervisor's.
  RoutingTable::Parts routing;
  // What senders apply; replaced by the supervisor only.
  SharedTable table;

  message_centre_actor centre;
  session_manager_actor manager;
  supervisor_actor supervisor;
  file_keeper_actor file_keeper;

  // From any thread: stamped and routed by the table at once (engine rule 1),
  // into the components' mailboxes; by the message centre what sessions get.
  // `held` may be none; what comes of the message takes it, so that it need not
  // be counted anew.
  void publish(Message&& message, Timestamp now, Work held);
  // Messages that happened together.
  void publish(std::vector<Message> messages);
  // Messages from outside that happened together: all of it by the message
  // centre, as who watches may bring them in while it is shown others.
  void bring_in(std::vector<Message> messages);
  // Stamped and routed, in this order; returned is what sessions get.
  std::vector<Message> route(std::vector<Message> messages);
  // Counted, and shown or else logged: a message that nobody took.
  // Nothing where nobody has to take it.
  void unhandled(const Message& message, const std::string& why);
  // The same for the sinks of a message that nobody fills.
  void unreached(const Routed& routed);
  // Shown, or else logged: what went wrong with a message on its way.
  void failed(const Message& message, const Error& error);
  // Whether it is what somebody said, as a recogniser heard it.
  bool is_heard(const Message& message) const;
};

} // namespace parlour::actors
