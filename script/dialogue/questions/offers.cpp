#include "script/dialogue/questions/offers.hpp"

#include <memory>
#include <utility>

namespace parlour::dialogue {

namespace {

// How many numbers are remembered. Each is asked for soon after it is noted, so
// what piles up belongs to utterances that were dropped; the oldest is
// forgotten then.
constexpr std::size_t max_consumed = 1000;

} // namespace

OfferId Offers::next_offer() {
  if (consumed_.size() > max_consumed)
    consumed_.erase(consumed_.begin());
  return ++offered_;
}

void Offers::offer(std::string command, Value parameter, OfferId number,
                   Step otherwise) {
  Message message;
  message.source = dialogue_source;
  message.command = std::move(command);
  message.params = {std::move(parameter)};
  message.time = context_.now;
  message.session = context_.options.session;
  message.number = number;
  const auto matches = reactions_.matches(dialogue_source, message.command);
  const auto input =
      input_of(std::make_shared<const Message>(std::move(message)));
  StepList steps;
  bool captured = false;
  for (const auto& match : matches) {
    steps.add(steps::React{{.code = match.reaction->body,
                            .turn = turn_of(otherwise),
                            .origin = {.visit = match.visit},
                            .input = input}});
    captured = captured || match.captures;
  }
  if (!captured)
    steps.add(std::move(otherwise));
  context_.lane.now(std::move(steps));
}

bool Offers::was_consumed(OfferId number) {
  return consumed_.erase(number) > 0;
}

} // namespace parlour::dialogue
