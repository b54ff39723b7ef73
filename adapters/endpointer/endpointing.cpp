#include "adapters/endpointer/endpointing.hpp"

#include <limits>
#include <utility>

namespace parlour::adapters {

namespace {

// A detector says that speech has started up to this long after it did.
constexpr Milliseconds detector_delay{500};

} // namespace

TurnSteps Endpointing::hear(Value frame, std::int64_t position) {
  now_ = position;
  kept_.push_back({std::move(frame), position});
  TurnSteps steps;
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
}

// -- turns
// ----------------------------------------------------------------------

// A cough while the robot speaks does not interrupt it, whereas in silence
// every speech counts at once.
bool Endpointing::is_turn() const {
  if (!speech_start_)
    return false;
  const auto spoken = speech_end_.value_or(now_) - *speech_start_;
  return !robot_speaks_ || spoken >= times_.interruption.count();
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
  const auto kept = times_.margin + detector_delay + times_.interruption;
  while (!kept_.empty() && kept_.front().position < now_ - kept.count())
    kept_.pop_front();
  if (speech_end_ && now_ - *speech_end_ > kept.count()) {
    speech_start_.reset();
    speech_end_.reset();
  }
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
  kept_.clear();
  return steps;
}

} // namespace parlour::adapters
