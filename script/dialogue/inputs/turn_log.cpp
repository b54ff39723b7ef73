#include "script/dialogue/inputs/turn_log.hpp"

#include <algorithm>

#include "runtime/message/typed_turn.hpp"

namespace parlour::dialogue {

namespace {

// More than a robot says in one turn; it only bounds what is kept with each
// state.
constexpr std::size_t most_said = 64;

} // namespace

// What was said is forgotten when the user speaks again; what answers a turn
// that is still open stays.
void TurnLog::take(const SessionInput& input) {
  const auto* got = std::get_if<input::Received>(&input);
  if (!got || got->message->command != "RecognitionResult")
    return;
  if (taken == done)
    said.clear();
  taken = std::max(taken, number_of_turn(*got->message));
}

// Of several open turns, what is said counts for the first.
void TurnLog::release(const Output& output) {
  if (said.size() == most_said)
    said.erase(said.begin());
  said.push_back(
      {taken > done ? done + 1 : 0, output.id, output.act, output.text});
}

// All open turns are answered together: nobody can tell which of them a word
// was for.
void TurnLog::dealt_with(const Conversation& conversation, Timestamp now) {
  if (conversation.ended() || (taken != done && conversation.has_answered(now)))
    done = taken;
}

} // namespace parlour::dialogue
