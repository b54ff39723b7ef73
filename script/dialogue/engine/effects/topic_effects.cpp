#include "script/dialogue/engine/effects/topic_effects.hpp"

#include <memory>
#include <utility>

#include "script/dialogue/engine/effects/effect_operands.hpp"

namespace parlour::dialogue {

namespace {

// While a session ends, a question would wait for somebody who is gone (engine
// rule 4.6).
Error nobody_answers() {
  return {ErrorKind::cancelled, "the session ends: nobody answers", {}};
}

Error no_topic(const script::Effect& effect) {
  return missing("topic", effect.operand(0));
}

} // namespace

// -- what operands name -------------------------------------------------------

// The compiler has looked up a name that is constant (`target`); only one that
// is computed is looked up now.
StateId TopicEffects::state_of(Call effect) const {
  return effect.target != script::no_id
             ? effect.target
             : context_.program->state(effect.text(0));
}

TopicId TopicEffects::topic_of(Call effect) const {
  return effect.target != script::no_id
             ? effect.target
             : context_.program->topic(effect.text(0));
}

SlotId TopicEffects::slot_of(TopicId topic, const std::string& name) const {
  return topic == script::no_id ? script::no_id
                                : context_.topic(topic).slot(name);
}

template <class Kind>
TopicEffects::Performed TopicEffects::later(Context context, Call effect,
                                            Kind step) {
  step.topic = effect.has(0) ? topic_of(effect) : context.topic;
  if (effect.has(0) && step.topic == script::no_id)
    return no_topic(effect);
  running_.later(std::move(step));
  return Value();
}

template <class Kind>
TopicEffects::Performed TopicEffects::later_of_topic(Context context,
                                                     Call effect, Kind step) {
  if (!effect.has(0) && context.topic == script::no_id)
    return Error{
        ErrorKind::refused, "only a topic's own script can do this", {}};
  return later(context, effect, std::move(step));
}

// -- states -------------------------------------------------------------------

// The children of <transit> run between Exit and Entrance, with the local
// variables as they are now and with the message of this script.
script::Performed TopicEffects::transit(Context context, Call effect) {
  running_.redirect();
  context_.reached(effect.position);
  const auto state = state_of(effect);
  if (state == script::no_id)
    return missing("state", effect.operand(0));
  Body body{.code = effect.body,
            .topic = context.topic,
            .slot = context.slot,
            .turn = context.turn};
  if (effect.body != script::no_code)
    body.input = std::make_shared<const BodyInput>(
        BodyInput{effect.captured(), context.message});
  running_.later(steps::Transit{state, std::move(body)});
  return Value();
}

// The wait begins here and the state is entered by a later step, so that what
// the script has asked for before comes first.
script::Performed TopicEffects::push(Context context, Call effect) {
  if (context_.ending.has_begun())
    return nobody_answers();
  const auto state = state_of(effect);
  if (state == script::no_id)
    return missing("state", effect.operand(0));
  context_.reached(effect.position);
  running_.later(steps::Push{.state = state,
                             .topic = context.topic,
                             .turn = context.turn,
                             .wait = running_.begin_wait(WaitFor::user)});
  return script::Waits{};
}

script::Performed TopicEffects::pop(Context context) {
  if (!context_.states.pushed())
    return Error{ErrorKind::refused, "<pop>: no state was pushed", {}};
  running_.later(steps::Pop{context.turn});
  return Value();
}

// -- topics -------------------------------------------------------------------

script::Performed TopicEffects::activate(Context context, Call effect) {
  return later(
      context, effect,
      steps::Activate{.turn = context.turn, .keep = bool(effect.operand(1))});
}

script::Performed TopicEffects::reset(Context context, Call effect) {
  return later_of_topic(context, effect, steps::Reset{});
}

script::Performed TopicEffects::complete(Context context, Call effect) {
  return later_of_topic(context, effect, steps::Complete{.turn = context.turn});
}

script::Performed TopicEffects::cancel(Context context, Call effect) {
  return later(
      context, effect,
      steps::Cancel{.turn = context.turn, .all = bool(effect.operand(1))});
}

// With a slot it asks for that slot; without one it repeats the question that
// waits.
script::Performed TopicEffects::ask(Context context, Call effect) {
  running_.redirect();
  if (!effect.operand(0).is_unknown())
    return ask_slot(context, effect);
  const bool same_words = text_or(effect.operand(1), "next") == "same";
  running_.later(steps::AskAgain{context.turn, same_words});
  return Value();
}

script::Performed TopicEffects::ask_slot(Context context, Call effect) {
  const auto slot = slot_of(context.topic, effect.text(0));
  if (slot == script::no_id)
    return missing("slot", effect.operand(0));
  running_.later(
      steps::Ask{.topic = context.topic, .slot = slot, .turn = context.turn});
  return Value();
}

script::Performed TopicEffects::confirm(Context context, Call effect) {
  if (context_.ending.has_begun())
    return nobody_answers();
  const auto slot = effect.has(1) ? slot_of(context.topic, effect.text(1))
                                  : SlotId{script::no_id};
  if (effect.has(1) && slot == script::no_id)
    return missing("slot", effect.operand(1));
  const auto wait = running_.begin_wait(WaitFor::user);
  confirmations_.confirm(effect.text(0), context.topic, slot, wait,
                         context.turn);
  return script::Waits{};
}

// What was said for certain needs no yes where the topic allows that.
script::Performed TopicEffects::summarise(Context context, Call effect) {
  if (effect.operand(0) && frames_[context.topic].certain)
    return Value(true);
  if (context_.ending.has_begun())
    return nobody_answers();
  confirmations_.summarise(context.topic, running_.begin_wait(WaitFor::user),
                           context.turn);
  return script::Waits{};
}

script::Performed TopicEffects::ask_change(Context context) {
  running_.redirect();
  running_.later(steps::Ask{.topic = context.topic, .turn = context.turn});
  return Value();
}

// A slot that is cleared is asked for again, so the body does not lead to the
// topic's end, and a question about its value makes no sense any more.
script::Performed TopicEffects::clear(Context context, Call effect) {
  const auto topic = context.topic;
  const auto slot = slot_of(topic, effect.text(0));
  if (slot == script::no_id)
    return missing("slot", effect.operand(0));
  running_.redirect();
  frames_.change(topic, {.kind = FrameChange::Kind::clear, .slot = slot});
  confirmations_.slot_changed(topic);
  return Value();
}

script::Performed TopicEffects::register_topic(Call effect) {
  const auto topic = topic_of(effect);
  if (topic == script::no_id)
    return no_topic(effect);
  if (effect.kind == script::EffectKind::register_topic)
    frames_.order().register_topic(topic);
  else
    frames_.order().unregister_topic(topic);
  return Value();
}

// -- words --------------------------------------------------------------------

// In a reaction to NLG.Speak the words are for the output that waits for them
// (engine rule 3.4), which the message's correlation tells.
script::Performed TopicEffects::speak(Context context, Call effect) {
  auto handled = context.message ? context.message->correlation : 0;
  output_.speak(effect.text(0), handled, context.turn,
                !effect.has(1) || effect.operand(1));
  return Value();
}

// About the topic and slot that it names, else those it stands in.
script::Performed TopicEffects::say(Context context, Call effect) {
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
    what.slot = slot_of(what.topic, effect.text(2));
    if (what.slot == script::no_id)
      return missing("slot", effect.operand(2));
  }
  what.data = effect.operand(3).is_unknown()
                  ? repairs_.data_of(what.act, what.topic, what.slot)
                  : effect.operand(3);
  output_.say(std::move(what));
  return Value();
}

script::Performed TopicEffects::repeat(Context context) {
  words_.repeat(context.turn);
  return Value();
}

void TopicEffects::set_slot(TopicId topic, SlotId slot, Value value) {
  if (topic == script::no_id)
    return;
  running_.acts();
  frames_.change(topic, {.kind = FrameChange::Kind::set,
                         .slot = slot,
                         .value = std::move(value)});
  confirmations_.slot_changed(topic);
}

} // namespace parlour::dialogue
