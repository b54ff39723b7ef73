#include "script/dialogue/engine/effects/subscriptions.hpp"

#include <algorithm>

#include "runtime/message/roles.hpp"
#include "script/dialogue/engine/effects/effect_operands.hpp"

namespace parlour::dialogue {

namespace {

// Of one session (language rule 12.15).
constexpr std::size_t max_subscriptions = 100;

constexpr const char* any = "*";

Subscription subscription_of(const script::Effect& effect) {
  return {effect.text(0), text_or(effect.operand(1), any)};
}

Error refused(std::string message) {
  return {ErrorKind::refused, std::move(message), {}};
}

bool is_reserved(const std::string& source) {
  const auto* role = find_role(source);
  return role && role->reserved;
}

} // namespace

script::Performed Subscriptions::add(const script::Effect& effect) {
  auto wanted = subscription_of(effect);
  if (wanted.source.empty() || wanted.command.empty())
    return refused("<subscribe> needs a source, and a command that is not "
                   "empty");
  if (is_reserved(wanted.source))
    return refused("events of '" + wanted.source +
                   "' come without <subscribe>");
  if (std::ranges::count(all_, wanted) != 0)
    return Value();
  if (all_.size() == max_subscriptions)
    return refused("a session has no more than " +
                   std::to_string(max_subscriptions) + " subscriptions");
  all_.push_back(std::move(wanted));
  port_.subscribe(all_);
  return Value();
}

// Nothing happens where there is none. What was subscribed as a whole cannot be
// taken back in part.
script::Performed Subscriptions::remove(const script::Effect& effect) {
  const auto unwanted = subscription_of(effect);
  const auto count = std::erase_if(all_, [&](const Subscription& one) {
    return (unwanted.source == any || unwanted.source == one.source) &&
           (unwanted.command == any || unwanted.command == one.command);
  });
  if (count != 0)
    port_.subscribe(all_);
  else if (std::ranges::count(all_, Subscription{unwanted.source, any}) != 0)
    return refused("all events of '" + unwanted.source +
                   "' are subscribed: <unsubscribe source=\"" +
                   unwanted.source + "\"/> takes all of them back");
  return Value();
}

} // namespace parlour::dialogue
