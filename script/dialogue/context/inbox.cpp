#include "script/dialogue/context/inbox.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/defaults.hpp"

namespace parlour::dialogue {

namespace {

// The first message that counts.
template <class Inputs>
auto find_next(Inputs& inputs, Inbox::Of whom) {
  return whom == Inbox::Of::all ? inputs.begin()
                                : std::find_if(inputs.begin(), inputs.end(),
                                               [](const Input& input) {
                                                 return !input.begins_turn;
                                               });
}

} // namespace

void Inbox::receive(Input&& input) {
  received_ = std::max(received_, input.message->number);
  has_received_ = true;
  turns_.hold(input.turn);
  messages_.push_back(std::move(input));
}

void Inbox::put_back(Input&& input) {
  messages_.push_front(std::move(input));
}

bool Inbox::has_message(Of whom) const {
  return find_next(messages_, whom) != messages_.end();
}

std::optional<Input> Inbox::take_message(Of whom) {
  const auto next = find_next(messages_, whom);
  return next == messages_.end() ? std::nullopt
                                 : std::optional(messages_.take(next));
}

Fifo<Input> Inbox::take_unread() {
  return std::exchange(messages_, {});
}

void Inbox::add_internal(Input&& input) {
  turns_.hold(input.turn);
  internal_.push_back(std::move(input));
}

void Inbox::external_event_begins() {
  internal_count_ = 0;
  rounds_ = 0;
  is_told_ = false;
}

// A handler that fires the event which it handles would never end. Its events
// are dropped, not the messages from outside: the user is still heard.
Inbox::Count Inbox::count_internal() {
  if (++internal_count_ <= defaults::internal_events)
    return Count::within;
  for (auto& input : std::exchange(internal_, {})) {
    turns_.let_go(input.turn);
    dropped_.push_back(std::move(input));
  }
  if (std::exchange(is_told_, true))
    return Count::above;
  internal_count_ = 0; // those who hear of it may do something about it
  return Count::just_above;
}

Fifo<Input> Inbox::take_dropped() {
  return std::exchange(dropped_, {});
}

} // namespace parlour::dialogue
