#include "script/dialogue/context/script_view.hpp"

#include <optional>

#include "script/dialogue/frame/frame_view.hpp"

namespace parlour::dialogue {

namespace {

// What a message Script.Error tells, as <catch> would see it.
Value error_of(const Message& message) {
  const Value params(message.params);
  return Map{{"message", params.at(0)},
             {"file", params.at(1)},
             {"line", params.at(2)}};
}

} // namespace

Value ScriptView::slot(TopicId topic, SlotId slot) const {
  if (topic == script::no_id)
    return {};
  auto value = read_slot(frames_[topic], slot);
  context_.conceal(topic, slot, value);
  return value;
}

// A handler has no topic of its own: there _TOPIC means the current one.
Value ScriptView::system(const script::ActivationContext& context,
                         script::SystemVariable variable) const {
  using enum script::SystemVariable;
  const auto current = context.topic != script::no_id
                           ? context.topic
                           : frames_.order().current().value_or(script::no_id);
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
        in_topic ? std::optional(current) : frames_.order().latest();
    return shown && frames_[*shown].done;
  }
  case error: // in a <catch> it is a local of the script
    return context.handles_error ? error_of(*context.message) : Value();
  default:
    return {}; // those of the message come from the activation
  }
}

void ScriptView::log(const script::Effect& effect) {
  context_.inspect(InspectionKind::log,
                   effect.has(1) ? effect.text(1) : std::string("info"),
                   effect.text(0));
}

} // namespace parlour::dialogue
