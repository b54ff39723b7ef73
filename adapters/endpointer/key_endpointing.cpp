#include "adapters/endpointer/key_endpointing.hpp"

#include <utility>

namespace parlour::adapters {

TurnSteps KeyEndpointing::hear(Value frame, std::int64_t position) {
  now_ = position;
  TurnSteps steps;
  if (start_) {
    steps.push_back(TurnAudio{std::move(frame)});
    const bool is_over = release_ && now_ - *release_ >= times_.after.count();
    if (is_over)
      end(steps);
    else if (now_ - *start_ >= times_.longest.count()) {
      // Who still holds the key goes on in a turn of its own.
      end(steps);
      if (!release_)
        begin(steps);
    }
    return steps;
  }
  kept_.push_back({std::move(frame), position});
  while (kept_.front().position < now_ - times_.before.count())
    kept_.pop_front();
  return steps;
}

void KeyEndpointing::begin(TurnSteps& steps) {
  start_ = now_;
  release_.reset();
  steps.push_back(TurnStarted{now_});
  for (auto& frame : kept_)
    steps.push_back(TurnAudio{std::move(frame.audio)});
  kept_.clear();
}

void KeyEndpointing::end(TurnSteps& steps) {
  const auto last = release_.value_or(now_);
  if (last - *start_ < times_.shortest.count())
    steps.push_back(TurnDropped{last});
  else
    steps.push_back(TurnEnded{last});
  start_.reset();
}

// Who presses again before the turn has ended goes on with it.
TurnSteps KeyEndpointing::pressed() {
  TurnSteps steps;
  if (start_)
    release_.reset();
  else
    begin(steps);
  return steps;
}

TurnSteps KeyEndpointing::released() {
  if (start_ && !release_)
    release_ = now_;
  return {};
}

TurnSteps KeyEndpointing::finish() {
  TurnSteps steps;
  if (start_)
    end(steps);
  kept_.clear();
  return steps;
}

TurnSteps KeyEndpointing::reset() {
  TurnSteps steps;
  if (start_)
    steps.push_back(TurnDropped{now_});
  start_.reset();
  release_.reset();
  kept_.clear();
  now_ = 0;
  return steps;
}

} // namespace parlour::adapters
