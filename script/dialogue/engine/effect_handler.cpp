#include "script/dialogue/engine/effect_handler.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/effect_deeds.hpp"
#include "script/dialogue/engine/effect_operands.hpp"
#include "script/dialogue/frame/frame_view.hpp"
#include "script/program/effect_names.hpp"
#include "script/program/file_effect.hpp"

namespace parlour::dialogue {

namespace {

Error not_yet(const script::Effect& effect) {
  return {ErrorKind::refused,
          "<" + script::element_of(effect.kind) + "> is not available yet",
          {}};
}

Error nobody_answers() {
  return {ErrorKind::cancelled, "the session ends: nobody answers", {}};
}

// Those that name no topic and mean the one that they stand in.
bool means_own_topic(StepKind kind) {
  return kind == StepKind::complete || kind == StepKind::reset;
}

// What a message Script.Error tells, as <catch> would see it.
Value error_of(const Message& message) {
  const Value params(message.params);
  return Map{{"message", params.at(0)},
             {"file", params.at(1)},
             {"line", params.at(2)}};
}

} // namespace

EffectHandler::EffectHandler(DialogueContext& context, ActivationRunner& runner,
                             Waits& waits, Reactions& reactions,
                             OutputManager& output, TopicEngine& topics,
                             StateMachine& machine, ScriptSockets& sockets,
                             Pipeline& pipeline)
    : context_(context), runner_(runner), waits_(waits), reactions_(reactions),
      output_(output), topics_(topics), machine_(machine), sockets_(sockets),
      pipeline_(pipeline), subscriptions_(context.port),
      random_(context.options.seed) {}

script::Performed EffectHandler::perform(script::Activation& activation,
                                         const script::Effect& effect) {
  using enum script::EffectKind;
  if (is_deed(effect))
    runner_.acts();
  Context context = activation.context();
  switch (effect.kind) {
  case post:
    return this->post(context, effect);
  case request:
    return this->request(context, effect);
  case fire_frames:
    return this->fire_frames(context, effect);
  case fire_event:
    context_.raise("Script", effect.text(0), list_of(effect.operand(1)),
                   context.turn);
    return Value();
  case speak:
    return this->speak(context, effect);
  case consume:
    return this->consume(context);
  case register_handler:
  case unregister_handler:
    reactions_.register_handler(effect.text(0),
                                effect.kind == register_handler);
    return Value();
  case timer:
    return this->timer(context, effect);
  case cancel:
    context_.timers.cancel_named(effect.text(0));
    return Value();
  case wait:
    return wait_for(milliseconds(effect.operand(0)));
  case confirm:
    return this->confirm(context, effect);
  case log:
  case print:
    context_.inspect(InspectionKind::log, text_or(effect.operand(1), "info"),
                     effect.text(0));
    return Value();
  default:
    return perform_dialogue(activation, effect);
  }
}

script::Performed EffectHandler::consume(Context context) {
  if (context.message && context.message->source == "Dialogue")
    topics_.consume(context.message->number);
  else if (!pipeline_.consume())
    return Error{
        ErrorKind::refused, "<consume>: no message is being handled here", {}};
  return Value();
}

// What concerns states and topics; most of it happens when the activation ends
// or waits (engine rule 2).
script::Performed
EffectHandler::perform_dialogue(script::Activation& activation, Call effect) {
  Context context = activation.context();
  using enum script::EffectKind;
  if (context.leaves_state && script::leads_elsewhere(effect.kind))
    return Error{ErrorKind::refused,
                 "<" + script::element_of(effect.kind) +
                     "> cannot lead elsewhere while a state is being left, in "
                     "its Exit or in a <transit>",
                 {}};
  switch (effect.kind) {
  case transit:
    return this->transit(context, effect);
  case push:
    return this->push(context, effect);
  case pop:
    return machine_.is_pushed()
               ? later(StepKind::pop, context, effect)
               : Error{ErrorKind::refused, "<pop>: no state was pushed", {}};
  case end:
    return later(StepKind::end, context, effect);
  case activate:
    return later(StepKind::activate, context, effect);
  case reset_topic:
    return later(StepKind::reset, context, effect);
  case complete:
    return later(StepKind::complete, context, effect);
  case ask:
    runner_.redirect();
    return effect.operand(0).is_unknown()
               ? ask_again(context, effect)
               : later(StepKind::ask, context, effect);
  case clear:
    return this->clear(context, effect);
  case register_topic:
  case unregister_topic:
    return this->register_topic(effect);
  default:
    return perform_repair(activation, effect);
  }
}

// Databases, files, sockets, components.
script::Performed EffectHandler::perform_outside(script::Activation& activation,
                                                 Call effect) {
  Context context = activation.context();
  using enum script::EffectKind;
  if (auto request = script::file_request(
          effect, context_.program->settings.limits.result))
    return file(std::move(*request));
  switch (effect.kind) {
  case connectdb:
    return connect_database(activation, effect);
  case querydb:
    return query_database(context, effect);
  case begin:
    return transaction(context, effect, QueryRequest::Kind::begin);
  case commit:
    return transaction(context, effect, QueryRequest::Kind::commit);
  case rollback:
    return transaction(context, effect, QueryRequest::Kind::rollback);
  case open_socket:
    return this->open_socket(effect);
  case send_socket:
    return sockets_.send(effect);
  case close_socket:
    return sockets_.close(effect);
  case script::EffectKind::subscribe:
    return subscriptions_.add(effect);
  case unsubscribe:
    return subscriptions_.remove(effect);
  case load:
  case unload:
    return change_component(effect);
  default:
    return not_yet(effect);
  }
}

// -- waits --------------------------------------------------------------------

WaitId EffectHandler::begin_wait(ActivationRunner::WaitFor what) {
  auto id = context_.next_id();
  runner_.expect({id, what});
  return id;
}

script::Performed EffectHandler::confirm(Context context, Call effect) {
  if (context_.leaving)
    return nobody_answers();
  auto slot = script::no_id;
  if (effect.has(1) && context.topic != script::no_id)
    slot = context_.topic(context.topic).slot(effect.text(1));
  auto wait = begin_wait(ActivationRunner::WaitFor::user);
  topics_.confirm(effect.text(0), context.topic, slot, wait, context.turn);
  return script::Waits{};
}

script::Performed EffectHandler::push(Context context, Call effect) {
  if (context_.leaving)
    return nobody_answers();
  const auto state = state_of(effect);
  if (state == script::no_id)
    return missing("state", effect.operand(0));
  reached(effect.position);
  Step step;
  step.kind = StepKind::push;
  step.state = state;
  step.topic = context.topic;
  step.turn = context.turn;
  step.wait = begin_wait(ActivationRunner::WaitFor::user);
  runner_.later(std::move(step));
  return script::Waits{};
}

// -- states and topics --------------------------------------------------------

// What operand 0 names; no_id where there is none.
StateId EffectHandler::state_of(Call effect) const {
  return effect.target != script::no_id
             ? effect.target
             : context_.program->state(effect.text(0));
}

TopicId EffectHandler::topic_of(Call effect) const {
  return effect.target != script::no_id
             ? effect.target
             : context_.program->topic(effect.text(0));
}

script::Performed EffectHandler::transit(Context context, Call effect) {
  runner_.redirect();
  reached(effect.position);
  const auto state = state_of(effect);
  if (state == script::no_id)
    return missing("state", effect.operand(0));
  auto& step = runner_.later(StepKind::transit);
  step.state = state;
  step.topic = context.topic;
  step.slot = context.slot;
  step.turn = context.turn;
  if (effect.body != script::no_code) {
    step.code = effect.body;
    step.matter().arguments = effect.captured();
    step.matter().message = context.message;
  }
  return Value();
}

script::Performed EffectHandler::later(StepKind kind, Context context,
                                       Call effect) {
  Step step;
  step.kind = kind;
  step.turn = context.turn;
  step.topic = context.topic;
  if (kind == StepKind::activate || kind == StepKind::cancel)
    step.mark = effect.operand(1) ? 1 : 0;
  if (kind == StepKind::ask) {
    step.slot = context.topic == script::no_id
                    ? script::no_id
                    : context_.topic(context.topic).slot(effect.text(0));
    if (step.slot == script::no_id)
      return missing("slot", effect.operand(0));
  } else if (effect.has(0)) {
    step.topic = topic_of(effect);
    if (step.topic == script::no_id)
      return missing("topic", effect.operand(0));
  } else if (step.topic == script::no_id && means_own_topic(kind)) {
    return Error{
        ErrorKind::refused, "only a topic's own script can do this", {}};
  }
  runner_.later(std::move(step));
  return Value();
}

script::Performed EffectHandler::register_topic(Call effect) {
  const auto topic = topic_of(effect);
  if (topic == script::no_id)
    return missing("topic", effect.operand(0));
  if (effect.kind == script::EffectKind::register_topic)
    context_.order.register_topic(topic);
  else
    context_.order.unregister_topic(topic);
  return Value();
}

script::Performed EffectHandler::clear(Context context, Call effect) {
  auto topic = context.topic;
  auto slot = topic == script::no_id
                  ? script::no_id
                  : context_.topic(topic).slot(effect.text(0));
  if (slot == script::no_id)
    return missing("slot", effect.operand(0));
  runner_.redirect();
  topics_.change(topic, {.kind = FrameChange::Kind::clear, .slot = slot});
  topics_.slot_changed(topic);
  return Value();
}

Value EffectHandler::slot(TopicId topic, SlotId slot) const {
  if (topic == script::no_id)
    return {};
  auto value = read_slot(context_.frame(topic), slot);
  context_.conceal(topic, slot, value);
  return value;
}

void EffectHandler::set_slot(TopicId topic, SlotId slot, Value value) {
  if (topic == script::no_id)
    return;
  runner_.acts();
  topics_.change(topic, {.kind = FrameChange::Kind::set,
                         .slot = slot,
                         .value = std::move(value)});
  topics_.slot_changed(topic);
}

// -- what scripts can look at -------------------------------------------------

Value EffectHandler::system(const script::Activation& activation,
                            script::SystemVariable variable) const {
  using enum script::SystemVariable;
  const auto& context = activation.context();
  auto current = context.topic != script::no_id
                     ? context.topic
                     : context_.order.current().value_or(script::no_id);
  const bool in_topic = current != script::no_id;
  switch (variable) {
  case session:
    return context_.options.session;
  case state:
    return context_.active_state() ? Value(context_.active_state()->name)
                                   : Value();
  case topic:
    return in_topic ? Value(context_.topic(current).name) : Value();
  case script::SystemVariable::slot:
    return in_topic && context.slot != script::no_id
               ? Value(context_.topic(current).slots[context.slot].name)
               : Value();
  case frame_done: { // everywhere, and still so when the topic has completed
    const auto shown =
        in_topic ? std::optional(current) : context_.order.latest();
    return shown && context_.frame(*shown).done;
  }
  case error: // in a <catch> it is a local of the script
    return context.handles_error ? error_of(*context.message) : Value();
  default:
    return {}; // those of the message come from the activation
  }
}

bool EffectHandler::online(const std::string& agent) const {
  return context_.port.reachable(agent);
}

Timestamp EffectHandler::now() const {
  return context_.now;
}

double EffectHandler::random() {
  return random_.fraction();
}

bool EffectHandler::watches_branches() const {
  return context_.port.inspected();
}

void EffectHandler::reached(script::Position position) {
  context_.reached(position);
}

} // namespace parlour::dialogue
