// Services: what the actors of one node share. Made by the node, which
// outlives its actors; immutable or safe to use from any thread once the node
// has started.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "actors/protocol/interfaces.hpp"
#include "actors/routing/instance_directory.hpp"
#include "actors/routing/query_claims.hpp"
#include "actors/routing/routing_table.hpp"
#include "actors/routing/session_directory.hpp"
#include "actors/routing/shared_table.hpp"
#include "actors/support/discretion.hpp"
#include "actors/support/due_times.hpp"
#include "actors/support/thread_gate.hpp"
#include "actors/support/work_count.hpp"
#include "runtime/base/inspection.hpp"
#include "runtime/base/phrases.hpp"
#include "runtime/plugin/catalogue.hpp"

namespace parlour::actors {

struct Services {
  explicit Services(ThreadGate::Kind kind)
      : due_times([this] { work.wake(); }), gate(kind) {}
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

  WorkCount work;
  DueTimes due_times;
  ThreadGate gate;
  SessionDirectory sessions;
  QueryClaims claims;
  std::shared_ptr<Counters> counters = std::make_shared<Counters>();

  std::shared_ptr<const script::Program> program;
  std::shared_ptr<const PhraseEvaluator> phrases;
  std::shared_ptr<const UnderstandingModel> understanding;
  ColumnReader columns;
  std::string data_folder;
  std::string application_folder;
  const Clock* clock = nullptr;
  // Components get threads of their own.
  bool detaches = false;
  // What scripts can load; may be empty.
  std::shared_ptr<PluginCatalogue> plugins;
  std::function<void(ComponentOrder&)> complete; // may be empty
  InstanceDirectory instances;
  // Both may be empty: then scripts have none.
  FileAccess files;
  std::shared_ptr<Sockets> sockets;

  // Something did not come to an end in time: what is left of the actors calls
  // nobody outside any more.
  std::atomic<bool> left_behind = false;

  // One call at a time; empty where nobody watches. Unless `inspect_all`, who
  // watches is told of errors, logs and unhandled messages only.
  std::function<void(Inspection)> inspect;
  bool inspect_all = true;
  // One call at a time; never empty.
  std::function<void(const std::string&)> log;
  // Null where nothing of the program is private.
  std::unique_ptr<Discretion> discretion;
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

// Shows each message to whoever watches; `services` has an `inspect`.
Tap inspection_tap(Services& services);

} // namespace parlour::actors
