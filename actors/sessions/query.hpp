// A query: asks the database component, waits for its answer no longer than its
// timeout, tells the session, and quits. While it waits it holds no thread: it
// is an actor with an empty mailbox.
#pragma once

#include "actors/routing/message_bus.hpp"
#include "script/dialogue/agenda/port.hpp"

namespace parlour::actors {

struct query_state {
  static inline const char* name = "query";
  DueTicket ticket;
  Correlation correlation = 0;
  NodeTime* time = nullptr;
  MessageBus* bus = nullptr;
  // What it claimed is claimed no more.
  ~query_state();
};

// What SessionPort::query hands over to the actor. `due` is in NodeTime
// already; the actor's ticket removes it.
struct QueryOrder {
  SessionId session_id;
  dialogue::QueryRequest request;
  Milliseconds timeout{0};
  DueTimes::Id due = 0;
  InFlight work; // until the component has been asked
};

query_actor::behavior_type
query(query_actor::stateful_pointer<query_state> self, NodeTime* time,
      MessageBus* bus, session_actor session, QueryOrder order);

} // namespace parlour::actors
