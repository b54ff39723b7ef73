#include "script/dialogue/agenda/turns.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

namespace {

// So many of the latest questions are remembered, answered ones included; an
// answer to an older one belongs to no turn. Fewer would lose the turn of a
// slow answer where a script posts a lot, more would only make saved sessions
// larger.
constexpr std::size_t remembered_questions = 256;

} // namespace

TurnId Turns::begin(Value heard) {
  speech_is_over();
  turns_.push_back({++last_, 0, false, std::move(heard)});
  return last_;
}

Value Turns::heard(TurnId turn) const {
  const auto found = std::ranges::find(turns_, turn, &Turn::id);
  return found == turns_.end() ? Value() : found->heard;
}

void Turns::let_go(TurnId turn) {
  if (auto* found = find(turn)) {
    --found->holders;
    close_if_idle(turn);
  }
}

// Correlations rise, so the first entry of the map is the oldest question.
void Turns::asked(Correlation correlation, TurnId turn, Timestamp until,
                  bool meaning) {
  if (!find(turn))
    return;
  questions_[correlation] = Question{turn, until, true, meaning};
  if (questions_.size() <= remembered_questions)
    return;
  const auto oldest = questions_.begin()->second.turn;
  questions_.erase(questions_.begin());
  close_if_idle(oldest);
}

TurnId Turns::of(Correlation correlation) const {
  if (correlation == 0)
    return 0;
  auto found = questions_.find(correlation);
  return found == questions_.end() ? 0 : found->second.turn;
}

void Turns::answered(Correlation correlation) {
  if (correlation == 0)
    return;
  auto found = questions_.find(correlation);
  if (found == questions_.end() || !found->second.open)
    return;
  found->second.open = false;
  close_if_idle(found->second.turn);
}

void Turns::taken_up(TurnId turn) {
  if (auto* found = find(turn)) {
    found->taken = true;
    close_if_idle(turn);
  }
}

// Only a turn whose meaning was asked for counts as not understood: a component
// that was told something by the way and never answers takes nothing from what
// the user said.
std::vector<TurnId> Turns::expire(Timestamp now) {
  std::vector<TurnId> without_meaning;
  for (auto& [correlation, question] : questions_) {
    if (!question.open || question.until > now)
      continue;
    question.open = false;
    const auto* turn = find(question.turn);
    if (question.meaning && turn && !turn->taken)
      without_meaning.push_back(question.turn);
    close_if_idle(question.turn);
  }
  return without_meaning;
}

bool Turns::any_waits(Timestamp now, TurnId besides) const {
  return std::any_of(turns_.begin(), turns_.end(), [&](const Turn& turn) {
    return turn.id != besides && waits(turn, now);
  });
}

bool Turns::said_since(TurnId turn, Timestamp now) const {
  return turn != 0 &&
         std::any_of(turns_.begin(), turns_.end(), [&](const Turn& other) {
           return other.id > turn && waits(other, now);
         });
}

bool Turns::waits(const Turn& turn, Timestamp now) const {
  return !turn.taken && (turn.holders > 0 || asked_until(turn.id, now) > now);
}

// While a script or a queued message holds a turn, no time can be told: its
// work ends by itself.
std::optional<Timestamp> Turns::open_until(Timestamp now) const {
  Timestamp latest = speech_until_;
  for (const auto& turn : turns_) {
    if (turn.taken)
      continue;
    if (turn.holders > 0)
      return std::nullopt;
    latest = std::max(latest, asked_until(turn.id, now));
  }
  return latest > now ? std::optional(latest) : std::nullopt;
}

Timestamp Turns::asked_until(TurnId turn, Timestamp now) const {
  Timestamp latest = 0;
  for (const auto& [correlation, question] : questions_)
    if (question.open && question.turn == turn && question.until > now)
      latest = std::max(latest, question.until);
  return latest;
}

// A turn is forgotten when nobody holds it and no answer on its behalf is due.
void Turns::close_if_idle(TurnId turn) {
  const auto* found = find(turn);
  if (!found || found->holders > 0)
    return;
  auto asked =
      std::any_of(questions_.begin(), questions_.end(), [&](const auto& entry) {
        return entry.second.open && entry.second.turn == turn;
      });
  if (!asked)
    turns_.erase(turns_.begin() + (found - turns_.data()));
}

} // namespace parlour::dialogue
