#include "adapters/metrics/turn_times.hpp"

#include <utility>

namespace parlour::adapters {

void TurnTimes::ended(Timestamp now, Milliseconds silence) {
  turn_ = Turn{};
  turn_->speech_end = now - silence.count();
  turn_->decided = now;
}

void TurnTimes::recognised(Timestamp now) {
  if (turn_ && !turn_->recognised)
    turn_->recognised = now;
}

void TurnTimes::understood(Timestamp now) {
  if (turn_ && turn_->recognised && !turn_->understood)
    turn_->understood = now;
}

// What the robot says before it has the words is no answer to them.
void TurnTimes::said(Timestamp now, std::int64_t utterance) {
  if (!turn_ || !turn_->recognised || turn_->said)
    return;
  turn_->said = now;
  turn_->utterance = utterance;
}

std::optional<Map> TurnTimes::sounded(Timestamp now, std::int64_t utterance) {
  if (!turn_ || !turn_->said || turn_->utterance != utterance)
    return std::nullopt;
  const auto turn = *std::exchange(turn_, std::nullopt);
  const auto since = [&](std::optional<Timestamp> time) {
    return time ? Value(*time - turn.speech_end) : Value();
  };
  return Map{{"speech_end", turn.speech_end},
             {"decided", since(turn.decided)},
             {"recognised", since(turn.recognised)},
             {"understood", since(turn.understood)},
             {"said", since(turn.said)},
             {"first_sound", since(now)}};
}

} // namespace parlour::adapters
