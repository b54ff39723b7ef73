// Messages that no session is named in, or one that is over: who takes them
// nevertheless. Decides without an actor.
#pragma once

#include <string>
#include <vector>

#include "actors/routing/routing_table.hpp"
#include "runtime/message/subscription.hpp"

namespace parlour::actors {

// "*" stands for any event; a source may be a role or a component's name.
bool is_subscribed(const std::vector<Subscription>& all,
                   const RoutingTable& table, const Message& message);

// Whether a conversation opens at the seat of that name, where there is none,
// for what one of the seat's own components has said: for a user's turn, or
// where an <open> or the seat's `opens` says so (engine rule 1.8).
bool opens_at(const std::string& seat, const RoutingTable& table,
              const Message& message);

// Leaves in `messages` those that are for a seat's next session, and returns
// the others that somebody should have taken, each in their order. `seat` is
// its name; empty where the messages were for a session that is over: its
// user's turns are for the next one, answers and events meant the old one.
std::vector<Message> take_others(std::vector<Message>& messages,
                                 const RoutingTable& table,
                                 const std::string& seat);

} // namespace parlour::actors
