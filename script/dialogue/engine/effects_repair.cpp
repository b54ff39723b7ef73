// What scripts want of the conversation itself: a phrase, the last question,
// the last words, an end of it.
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/core.hpp"
#include "script/dialogue/engine/effect_operands.hpp"
#include "script/dialogue/engine/effects.hpp"

namespace parlour::dialogue {

script::Performed Effects::perform_repair(script::Activation& activation,
                                          Call effect) {
  Context context = activation.context();
  using enum script::EffectKind;
  switch (effect.kind) {
  case script::EffectKind::say:
    return this->say(context, effect);
  case repeat:
    core_.topics.repeat(context.turn);
    return Value();
  case cancel_topic:
    return later(StepKind::cancel, context, effect);
  case restart:
    core_.runner.later(topic_step(StepKind::restart, script::no_id));
    return Value();
  default:
    return perform_outside(activation, effect);
  }
}

// About the topic and slot that it names, else those it stands in.
script::Performed Effects::say(Context context, Call effect) {
  Say what;
  what.act = effect.text(0);
  what.topic = context.topic;
  what.slot = context.slot;
  what.turn = context.turn;
  if (effect.has(1)) {
    what.topic = core_.program->topic(effect.text(1));
    what.slot = script::no_id;
    if (what.topic == script::no_id)
      return missing("topic", effect.operand(1));
  }
  if (effect.has(2)) {
    what.slot = what.topic == script::no_id
                    ? script::no_id
                    : core_.topic(what.topic).slot(effect.text(2));
    if (what.slot == script::no_id)
      return missing("slot", effect.operand(2));
  }
  what.data = effect.operand(3).is_unknown()
                  ? core_.topics.data_of(what.act, what.topic, what.slot)
                  : effect.operand(3);
  core_.mouth.say(std::move(what));
  return Value();
}

script::Performed Effects::ask_again(Context context, Call effect) {
  auto step = topic_step(StepKind::ask_again, context.topic);
  step.turn = context.turn;
  step.mark = text_or(effect.operand(1), "next") == "same" ? 1 : 0;
  core_.runner.later(std::move(step));
  return Value();
}

} // namespace parlour::dialogue
