#include "script/dialogue/engine/effects/time_effects.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/engine/effects/effect_operands.hpp"
#include "script/program/timer_limits.hpp"

namespace parlour::dialogue {

script::Performed TimeEffects::wait(const script::Effect& effect) {
  Timer timer{.purpose = Timer::Purpose::wait};
  if (auto full =
          timers_.refuse(timer, context_.program->settings.limits.bytes))
    return std::move(*full);
  timer.wait = running_.begin_wait(WaitFor::time);
  timers_.start(context_.in(milliseconds(effect.operand(0))), std::move(timer));
  return script::Waits{};
}

// A timer that its own statements set again repeats as well as one with
// `repeat`, so by itself it keeps no session open (engine rule 3.8). One whose
// state was left while its script went on is not started at all.
script::Performed TimeEffects::start_timer(TopicId topic,
                                           const script::Effect& effect) {
  const auto& origin = running_.origin();
  Timer timer;
  timer.name = effect.text(0);
  timer.code = effect.body;
  timer.arguments = effect.captured();
  timer.bytes = script::remembered(timer.arguments);
  timer.topic = topic;
  timer.visit = ends_with(effect.operand(4));
  // Where timers lead to timers, by whatever way, time passes: else it would
  // never be quiet.
  const auto after = std::max(milliseconds(effect.operand(1)), Milliseconds(1));
  if (effect.operand(2))
    timer.every = after;
  const bool repeats = effect.operand(2) || origin.timer == timer.code;
  timer.keeps_open = effect.has(3) ? bool(effect.operand(3)) : !repeats;
  if (auto full =
          timers_.refuse(timer, context_.program->settings.limits.bytes))
    return std::move(*full);
  timers_.cancel_named(timer.name); // a timer replaces one of its name
  if (timer.visit == 0 || context_.states.lasts(timer.visit))
    timers_.start(context_.in(after), std::move(timer));
  return Value();
}

script::Performed TimeEffects::stop_timer(const script::Effect& effect) {
  timers_.cancel_named(effect.text(0));
  return Value();
}

// A timer of a state's script ends with its state, unless it says otherwise;
// one of a topic or handler lives on, unless it says "state" (engine rule 4.7).
VisitId TimeEffects::ends_with(const Value& said) const {
  const auto with = text_or(said, "");
  if (with == "session")
    return 0;
  const auto own = running_.origin().visit;
  return own == 0 && with == "state" ? context_.states.visit() : own;
}

} // namespace parlour::dialogue
