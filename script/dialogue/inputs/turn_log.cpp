#include "script/dialogue/inputs/turn_log.hpp"

#include <algorithm>

#include "runtime/message/typed_turn.hpp"

namespace parlour::dialogue {

namespace {

constexpr std::size_t most_said = 64;

} // namespace

// What answers a turn that is still open stays.
void TurnLog::take(const SessionInput& input) {
  const auto* got = std::get_if<input::Received>(&input);
  if (!got || got->message->command != "RecognitionResult")
    return;
  if (taken == done)
    said.clear();
  taken = std::max(taken, number_of_turn(*got->message));
}

void TurnLog::release(const Output& output) {
  if (said.size() == most_said)
    said.erase(said.begin());
  said.push_back(
      {taken > done ? done + 1 : 0, output.id, output.act, output.text});
}

void TurnLog::dealt_with(const Conversation& conversation, Timestamp now) {
  if (conversation.ended() || (taken != done && conversation.has_answered(now)))
    done = taken;
}

} // namespace parlour::dialogue
