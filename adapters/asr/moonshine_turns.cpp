#include "adapters/asr/moonshine_turns.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::moonshine {

namespace {

// What an answer needs of the message; the audio has served its purpose.
Message order_of(const Message& message) {
  Message order;
  order.command = message.command;
  order.session = message.session;
  order.correlation = message.correlation;
  return order;
}

} // namespace

// Beyond 30 s of a turn, `samples` is 0: the rest is not heard.
MoonshineTurns::Place MoonshineTurns::add(const Message& audio,
                                          std::size_t samples) {
  Place place;
  if (!spoken_.contains(audio.session)) {
    place.is_new = true;
    place.dropped = drop_one();
    spoken_[audio.session] = ++last_;
    turns_[last_].order = order_of(audio);
  }
  place.turn = spoken_[audio.session];
  auto& turn = turns_[place.turn];
  place.samples = std::min(samples, max_samples - turn.samples);
  turn.samples += place.samples;
  return place;
}

// The oldest turn that nobody has finished.
std::optional<TurnNumber> MoonshineTurns::drop_one() {
  if (spoken_.size() < max_spoken)
    return {};
  const auto oldest = std::ranges::min_element(
      spoken_, {}, [](const auto& one) { return one.second; });
  const auto turn = oldest->second;
  erase(turns_.find(turn));
  return turn;
}

// The session may begin its next turn at once: this one is only known by its
// number from now on.
std::optional<TurnNumber> MoonshineTurns::finish(const Message& order) {
  const auto spoken = spoken_.find(order.session);
  if (spoken == spoken_.end())
    return {};
  const auto number = spoken->second;
  spoken_.erase(spoken);
  auto& turn = turns_[number];
  turn.order = order_of(order);
  turn.is_finished = true;
  ++finished_;
  return number;
}

MoonshineTurns::Cancelled MoonshineTurns::cancel(const SessionId& session) {
  Cancelled cancelled;
  for (auto next = turns_.begin(); next != turns_.end();) {
    const auto one = next++;
    if (one->second.order.session != session)
      continue;
    cancelled.turns.push_back(one->first);
    if (one->second.is_finished)
      cancelled.orders.push_back(std::move(one->second.order));
    erase(one);
  }
  spoken_.erase(session);
  return cancelled;
}

// A partial result that comes after Finish is outdated.
std::optional<MoonshineTurns::Partial>
MoonshineTurns::partial(TurnNumber number) {
  const auto found = turns_.find(number);
  if (found == turns_.end() || found->second.is_finished)
    return {};
  return Partial{found->second.order, ++found->second.revision};
}

std::optional<Message> MoonshineTurns::take(TurnNumber number) {
  const auto found = turns_.find(number);
  if (found == turns_.end() || !found->second.is_finished)
    return {};
  auto order = std::move(found->second.order);
  erase(found);
  return order;
}

std::vector<Message> MoonshineTurns::take_all() {
  std::vector<Message> orders;
  for (auto& [number, turn] : std::exchange(turns_, {}))
    if (turn.is_finished)
      orders.push_back(std::move(turn.order));
  spoken_.clear();
  finished_ = 0;
  return orders;
}

// The session may be empty already: its message was moved.
void MoonshineTurns::erase(std::map<TurnNumber, Turn>::iterator turn) {
  if (turn->second.is_finished)
    --finished_;
  std::erase_if(spoken_,
                [&](const auto& one) { return one.second == turn->first; });
  turns_.erase(turn);
}

} // namespace parlour::adapters::moonshine
