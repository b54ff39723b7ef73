#include "adapters/endpointer/turn_plugin.hpp"

#include <algorithm>
#include <utility>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

namespace {

constexpr Milliseconds silent_microphone{1'000};

} // namespace

TurnPlugin::TurnPlugin() : RolePlugin("Endpointer") {
  on("Process", &TurnPlugin::on_process);
  on("Reset", &TurnPlugin::on_reset);
}

void TurnPlugin::on_process(const Binary& audio,
                            std::optional<std::int64_t> position) {
  const Value frame = current().params.at(0); // shares the bytes
  const auto samples = speech_samples(frame);
  if (!samples)
    return refuse(samples.error().message);
  const auto begin = position.value_or(next_position_);
  const auto length = duration(audio.bytes.size() / sizeof(Sample));
  // A microphone that was stopped, or replaced, counts from 0 again.
  if (begin + length < next_position_)
    carry_out(reset());
  next_position_ = begin + length;
  remember_call();
  heard_ = true;
  carry_out(hear(frame, begin));
}

void TurnPlugin::on_reset() {
  next_position_ = 0;
  carry_out(reset());
}

// -- what follows
// --------------------------------------------------------------

void TurnPlugin::carry_out(TurnSteps steps) {
  for (auto& step : steps)
    carry_out(step);
  if (!in_turn() || watches_)
    return;
  // A turn may begin without audio, by a key.
  remember_call();
  watch();
}

void TurnPlugin::carry_out(TurnStep& step) {
  if (auto* const audio = std::get_if<TurnAudio>(&step))
    fire_event("Speech", {std::move(audio->frame)});
  else if (const auto* const start = std::get_if<TurnStarted>(&step))
    fire_event("TurnStarted", {start->position});
  else if (const auto* const end = std::get_if<TurnEnded>(&step))
    fire_event("TurnEnded",
               {end->position,
                std::max<std::int64_t>(0, next_position_ - end->position)});
  else if (const auto* const woken = std::get_if<Woken>(&step))
    fire_event("Woken", {woken->position});
  else if (const auto* const asleep = std::get_if<FellAsleep>(&step))
    fire_event("FellAsleep", {asleep->position});
  else
    fire_event("TurnDropped", {std::get<TurnDropped>(step).position});
}

void TurnPlugin::remember_call() {
  last_ = current();
  last_.params.clear();
}

void TurnPlugin::watch() {
  watches_ = true;
  heard_ = false;
  host().after(silent_microphone, [this] { look(); });
}

void TurnPlugin::look() {
  watches_ = false;
  if (!in_turn())
    return;
  if (heard_)
    return watch();
  as_answer_to(last_, [this] { carry_out(finish()); });
}

} // namespace parlour::adapters
