#include "adapters/endpointer/endpointing.hpp"

#include <limits>
#include <utility>

namespace parlour::adapters {

namespace {

// A detector says that speech has started up to this long after it did, and
// where the robot's own voice hid it, so much later.
constexpr Milliseconds detector_delay{500};
constexpr Milliseconds hidden{1'000};
// A word that wakes is found up to this long after it was said.
constexpr Milliseconds word_delay{3'000};

} // namespace

TurnSteps Endpointing::hear(Value frame, std::int64_t position) {
  now_ = position;
  kept_.push_back({std::move(frame), position});
  TurnSteps steps;
  rest(steps);
  if (!turn_ && is_turn())
    begin(steps);
  if (turn_ && is_over())
    end(steps);
  else if (turn_)
    pass(steps, speech_end_ ? *speech_end_ + times_.margin.count()
                            : std::numeric_limits<std::int64_t>::max());
  forget_old_frames();
  return steps;
}

// -- what is told
// --------------------------------------------------------------

// Within a turn the speaker goes on: what was recognised before tells nothing
// of where the sentence will end.
void Endpointing::speech_started(std::int64_t position) {
  if (turn_)
    turn_->ends.reset();
  else
    speech_start_ = position;
  speech_end_.reset();
}

void Endpointing::speech_ended(std::int64_t position) {
  if (speech_start_)
    speech_end_ = position;
}

void Endpointing::recognised(std::optional<bool> ends) {
  if (turn_)
    turn_->ends = ends;
}

void Endpointing::robot_speaks(bool speaks) {
  robot_speaks_ = speaks;
  if (speaks && times_.awake)
    is_asleep_ = false; // who is spoken to may answer
  active_at_ = now_;
}

// -- asleep
// ---------------------------------------------------------------------

void Endpointing::wake(std::optional<std::int64_t> word_end) {
  const auto position = word_end.value_or(now_);
  if (!times_.awake)
    return;
  active_at_ = now_;
  if (!std::exchange(is_asleep_, false) || !speech_start_)
    return;
  if (speech_end_ && *speech_end_ <= position) {
    speech_start_.reset();
    speech_end_.reset();
  } else if (*speech_start_ < position) {
    speech_start_ = position;
    follows_word_ = true;
  }
}

// A turn that is being spoken is still heard.
void Endpointing::sleep() {
  is_asleep_ = times_.awake.has_value();
}

void Endpointing::rest(TurnSteps& steps) {
  if (turn_ || speech_start_ || robot_speaks_)
    active_at_ = is_asleep_ ? active_at_ : now_;
  else if (times_.awake && now_ - active_at_ >= times_.awake->count())
    is_asleep_ = true;
  if (std::exchange(told_asleep_, is_asleep_) == is_asleep_)
    return;
  if (is_asleep_)
    steps.push_back(FellAsleep{now_});
  else
    steps.push_back(Woken{now_});
}

// -- turns
// ----------------------------------------------------------------------

// A cough while the robot speaks does not interrupt it, nor is the end of the
// word that woke it a turn, whereas in silence every speech counts at once.
bool Endpointing::is_turn() const {
  if (!speech_start_ || is_asleep_)
    return false;
  const auto spoken = speech_end_.value_or(now_) - *speech_start_;
  return (!robot_speaks_ && !follows_word_) ||
         spoken >= times_.interruption.count();
}

Milliseconds Endpointing::pause() const {
  if (!turn_->ends)
    return times_.usual;
  return *turn_->ends ? times_.after_sentence : times_.within_sentence;
}

bool Endpointing::is_over() const {
  return now_ - turn_->start >= times_.longest.count() ||
         (speech_end_ && now_ - *speech_end_ >= pause().count());
}

void Endpointing::begin(TurnSteps& steps) {
  turn_ = Turn{*speech_start_, *speech_start_ - times_.margin.count()};
  follows_word_ = false;
  steps.push_back(TurnStarted{turn_->start});
}

void Endpointing::pass(TurnSteps& steps, std::int64_t until) {
  while (!kept_.empty() && kept_.front().position <= until) {
    if (kept_.front().position >= turn_->from)
      steps.push_back(TurnAudio{std::move(kept_.front().audio)});
    kept_.pop_front();
  }
}

// Who is cut goes on in a turn of its own.
void Endpointing::end(TurnSteps& steps) {
  const auto last = speech_end_.value_or(now_);
  pass(steps, last + times_.margin.count());
  steps.push_back(TurnEnded{last});
  turn_.reset();
  speech_start_ = speech_end_ ? std::nullopt : std::optional(now_);
  speech_end_.reset();
}

// A short sound that the robot spoke over is dealt with, once it cannot become
// longer.
void Endpointing::forget_old_frames() {
  if (turn_)
    return;
  const auto kept = kept_time();
  while (!kept_.empty() &&
         kept_.front().position < now_ - kept - hidden.count())
    kept_.pop_front();
  if (speech_end_ && now_ - *speech_end_ > kept) {
    speech_start_.reset();
    speech_end_.reset();
    follows_word_ = false;
  }
}

std::int64_t Endpointing::kept_time() const {
  const auto kept = times_.margin + detector_delay + times_.interruption;
  return (is_asleep_ ? kept + word_delay : kept).count();
}

TurnSteps Endpointing::finish() {
  TurnSteps steps;
  if (turn_) {
    speech_end_ = speech_end_.value_or(now_);
    end(steps);
  }
  kept_.clear();
  return steps;
}

TurnSteps Endpointing::reset() {
  TurnSteps steps;
  if (turn_)
    steps.push_back(TurnDropped{now_});
  turn_.reset();
  speech_start_.reset();
  speech_end_.reset();
  follows_word_ = false;
  kept_.clear();
  now_ = 0;
  active_at_ = 0;
  return steps;
}

} // namespace parlour::adapters
