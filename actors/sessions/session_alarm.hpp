// SessionAlarm: rings for what a session itself watches by the clock, such as
// the silence of its visitor. Such times come and go with each turn, so they
// are no actors, as scripts' timers are: the session wakes once for all of
// them, and only then looks what is due.
#pragma once

#include <optional>
#include <vector>

#include "actors/protocol/interfaces.hpp"
#include "actors/routing/message_bus.hpp"
#include "actors/support/node_time.hpp"
#include "script/dialogue/agenda/port.hpp"

namespace parlour::actors {

// Owned by the session's port and used on its thread only. What is set has its
// due time in NodeTime, too, until it rings, is cancelled, or goes with this.
class SessionAlarm {
public:
  SessionAlarm(session_actor::pointer self, NodeTime& time, MessageBus& bus)
      : self_(self), time_(time), bus_(bus) {}

  // timer_due follows at that time; at once where it is over.
  void set(dialogue::TimerId id, Timestamp due);
  // Nothing happens where it is not set.
  void cancel(dialogue::TimerId id);
  void cancel_all();
  // On wake_up: what is due rings, and the session is to wake for the next.
  void wake();

private:
  struct Watch {
    dialogue::TimerId id = 0;
    Timestamp due = 0;
    DueTicket ticket; // its entry in NodeTime
  };

  void wake_at(Timestamp due);

  const session_actor::pointer self_;
  NodeTime& time_;
  MessageBus& bus_;
  std::vector<Watch> watches_; // in the order in which they were set
  // A wake_up is on its way for this time; nothing: none is.
  std::optional<Timestamp> wakes_at_;
};

} // namespace parlour::actors
