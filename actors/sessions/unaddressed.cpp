#include "actors/sessions/unaddressed.hpp"

#include <algorithm>
#include <iterator>

#include "runtime/message/roles.hpp"

namespace parlour::actors {

bool is_subscribed(const std::vector<Subscription>& all,
                   const RoutingTable& table, const Message& message) {
  return std::ranges::any_of(all, [&](const Subscription& one) {
    return (one.command == "*" || one.command == message.command) &&
           table.is_source(one.source, message.source);
  });
}

// An answer belongs to who has asked, and opens nothing.
bool opens_at(const std::string& seat, const RoutingTable& table,
              const Message& message) {
  return table.begins_turn(message) ||
         (message.correlation == 0 && table.opens(message, seat));
}

// What follows the one that opens the session is that session's, too. What the
// platform says is for who listens, and nobody has to.
std::vector<Message> take_others(std::vector<Message>& messages,
                                 const RoutingTable& table,
                                 const std::string& seat) {
  bool opened = false;
  auto others = std::stable_partition(
      messages.begin(), messages.end(), [&](const Message& message) {
        if (seat.empty())
          return table.begins_turn(message);
        opened = opened || opens_at(seat, table, message);
        return opened;
      });
  std::vector<Message> taken(std::make_move_iterator(others),
                             std::make_move_iterator(messages.end()));
  messages.erase(others, messages.end());
  if (!seat.empty())
    std::erase_if(taken, [](const Message& message) {
      const auto* role = find_role(message.source);
      return role && role->reserved;
    });
  return taken;
}

} // namespace parlour::actors
