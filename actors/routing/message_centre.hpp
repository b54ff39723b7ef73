// The message centre (paper III.A; engine rule 1): its table, which every
// sender applies itself (routing_table.hpp, MessageBus::publish), and this
// actor, which gives to sessions what they get, and to queries what they asked
// for. What comes from outside of the node it routes as well.
#pragma once

#include "actors/routing/message_bus.hpp"
#include "actors/routing/session_directory.hpp"

namespace parlour::actors {

// It keeps nothing of a message: all of its state is where to look. Lost
// sessions are the manager's concern, and a message that no session takes goes
// there, too.
struct message_centre_state {
  static inline const char* name = "message_centre";
  MessageBus* bus = nullptr;
  const SessionDirectory* sessions = nullptr;
  session_manager_actor manager; // of whose sessions it finds no handle
};

message_centre_actor::behavior_type message_centre(
    message_centre_actor::stateful_pointer<message_centre_state> self,
    MessageBus* bus, const SessionDirectory* sessions,
    session_manager_actor manager);

} // namespace parlour::actors
