#include "script/dialogue/engine/effects/effect_handler.hpp"

#include <utility>

#include "script/dialogue/engine/effects/effect_deeds.hpp"
#include "script/program/effect_names.hpp"

namespace parlour::dialogue {

// Each effect goes to its part, by the table. Two things are the same for all:
// what cannot be taken back is noted before it is done, and no effect may
// choose another state while one is being left (engine rule 4.2), which the
// compiler cannot see where the name of a function is computed.
script::Performed EffectHandler::perform(script::Activation& activation,
                                         Call effect) {
  if (is_deed(effect))
    running_.acts();
  const auto& context = activation.context();
  if (context.leaves_state && script::leads_elsewhere(effect.kind))
    return Error{ErrorKind::refused,
                 "<" + script::element_of(effect.kind) +
                     "> cannot lead elsewhere while a state is being left, in "
                     "its Exit or in a <transit>",
                 {}};
  switch (effect.kind) {
#define EFFECT(name, element, part, ...)                                       \
  case script::EffectKind::name:                                               \
    return part(activation, effect);
#include "script/program/effects.def"
#undef EFFECT
  }
  return Value();
}

// In this function and those below, what remains of the part's effects is the
// `default`.
script::Performed EffectHandler::requests(script::Activation& activation,
                                          Call effect) {
  const auto turn = activation.context().turn;
  switch (effect.kind) {
  case script::EffectKind::post:
    return requests_.post(turn, effect);
  case script::EffectKind::send:
    return requests_.send(turn, effect);
  default:
    return requests_.request(turn, effect);
  }
}

script::Performed EffectHandler::reactions(script::Activation& activation,
                                           Call effect) {
  using enum script::EffectKind;
  const auto& context = activation.context();
  switch (effect.kind) {
  case fire_frames:
    return reactions_.fire_frames(context.turn, effect);
  case fire_event:
    return reactions_.fire_event(context.turn, effect);
  case consume:
    return reactions_.consume(context.message.get());
  default:
    return reactions_.register_handler(effect);
  }
}

script::Performed EffectHandler::time(script::Activation& activation,
                                      Call effect) {
  using enum script::EffectKind;
  switch (effect.kind) {
  case timer:
    return time_.start_timer(activation.context().topic, effect);
  case cancel:
    return time_.stop_timer(effect);
  default:
    return time_.wait(effect);
  }
}

script::Performed EffectHandler::conversation(script::Activation&,
                                              Call effect) {
  using enum script::EffectKind;
  switch (effect.kind) {
  case end:
    running_.later(steps::End{});
    return Value();
  case restart:
    running_.later(steps::Restart{});
    return Value();
  default:
    view_.log(effect);
    return Value();
  }
}

script::Performed EffectHandler::outside(script::Activation& activation,
                                         Call effect) {
  return outside_.perform(activation, effect);
}

script::Performed EffectHandler::topics(script::Activation& activation,
                                        Call effect) {
  using enum script::EffectKind;
  const auto& context = activation.context();
  switch (effect.kind) {
  case speak:
    return topics_.speak(context, effect);
  case say:
    return topics_.say(context, effect);
  case repeat:
    return topics_.repeat(context);
  case transit:
    return topics_.transit(context, effect);
  case push:
    return topics_.push(context, effect);
  case pop:
    return topics_.pop(context);
  default:
    return about_topic(context, effect);
  }
}

script::Performed
EffectHandler::about_topic(const script::ActivationContext& context,
                           Call effect) {
  using enum script::EffectKind;
  switch (effect.kind) {
  case activate:
    return topics_.activate(context, effect);
  case reset_topic:
    return topics_.reset(context, effect);
  case complete:
    return topics_.complete(context, effect);
  case cancel_topic:
    return topics_.cancel(context, effect);
  case ask:
    return topics_.ask(context, effect);
  case confirm:
    return topics_.confirm(context, effect);
  case summarise:
    return topics_.summarise(context, effect);
  case ask_change:
    return topics_.ask_change(context);
  case clear:
    return topics_.clear(context, effect);
  default:
    return topics_.register_topic(effect);
  }
}

Value EffectHandler::slot(TopicId topic, SlotId slot) const {
  return view_.slot(topic, slot);
}

void EffectHandler::set_slot(TopicId topic, SlotId slot, Value value) {
  topics_.set_slot(topic, slot, std::move(value));
}

Value EffectHandler::system(const script::Activation& activation,
                            script::SystemVariable variable) const {
  return view_.system(activation.context(), variable);
}

bool EffectHandler::online(const std::string& agent) const {
  return view_.online(agent);
}

Timestamp EffectHandler::now() const {
  return view_.now();
}

double EffectHandler::random() {
  return view_.random();
}

bool EffectHandler::watches_branches() const {
  return view_.watches_branches();
}

void EffectHandler::reached(script::Position position) {
  view_.reached(position);
}

} // namespace parlour::dialogue
