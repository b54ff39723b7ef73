// What scripts want of the conversation itself: a phrase, the last question,
// the last words, an end of it.
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/effect_handler.hpp"
#include "script/dialogue/engine/effect_operands.hpp"

namespace parlour::dialogue {

script::Performed EffectHandler::perform_repair(script::Activation& activation,
                                                Call effect) {
  Context context = activation.context();
  using enum script::EffectKind;
  switch (effect.kind) {
  case script::EffectKind::say:
    return this->say(context, effect);
  case repeat:
    topics_.repeat(context.turn);
    return Value();
  case cancel_topic:
    return later(StepKind::cancel, context, effect);
  case restart:
    runner_.later(topic_step(StepKind::restart, script::no_id));
    return Value();
  default:
    return perform_outside(activation, effect);
  }
}

// About the topic and slot that it names, else those it stands in.
script::Performed EffectHandler::say(Context context, Call effect) {
  Say what;
  what.act = effect.text(0);
  what.topic = context.topic;
  what.slot = context.slot;
  what.turn = context.turn;
  if (effect.has(1)) {
    what.topic = context_.program->topic(effect.text(1));
    what.slot = script::no_id;
    if (what.topic == script::no_id)
      return missing("topic", effect.operand(1));
  }
  if (effect.has(2)) {
    what.slot = what.topic == script::no_id
                    ? script::no_id
                    : context_.topic(what.topic).slot(effect.text(2));
    if (what.slot == script::no_id)
      return missing("slot", effect.operand(2));
  }
  what.data = effect.operand(3).is_unknown()
                  ? topics_.data_of(what.act, what.topic, what.slot)
                  : effect.operand(3);
  output_.say(std::move(what));
  return Value();
}

script::Performed EffectHandler::ask_again(Context context, Call effect) {
  auto step = topic_step(StepKind::ask_again, context.topic);
  step.turn = context.turn;
  step.mark = text_or(effect.operand(1), "next") == "same" ? 1 : 0;
  runner_.later(std::move(step));
  return Value();
}

} // namespace parlour::dialogue
