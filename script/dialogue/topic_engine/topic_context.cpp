// The part of the topic engine that tells others where the conversation is: the
// classifier, and the understanding with each DoNLU.
#include <utility>

#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

ClassifierContext TopicEngine::classifier_context() const {
  ClassifierContext context;
  if (asked_ && asked_->heard && asked_->purpose != Asked::For::yes_or_no) {
    context.asked = asked_->topic;
    context.asked_slot = asked_->slot;
  }
  context.current = context_.order.current().value_or(completing());
  context.resting =
      context_.order
          .resting(context_.now,
                   context_.program->settings.sessions.context_for)
          .value_or(script::no_id);
  context.unfinished = context_.order.suspended();
  context.unregistered = context_.order.unregistered();
  return context;
}

// The latest last. None where the last turn has answered what is asked, though
// not well: a correction is of that.
List TopicEngine::names_said_before(SlotId asked) const {
  List names;
  if (said_.slots.empty() || said_.slots.back() == asked)
    return names;
  const auto& slots = context_.frame(said_.topic).slots;
  for (auto slot : said_.slots)
    if (slot != asked && slots[slot].status != SlotStatus::empty)
      names.emplace_back(context_.topic(said_.topic).slots[slot].name);
  return names;
}

// The question's own goes before the state's: without it, the question could
// not be answered.
const std::string&
TopicEngine::narrowing_grammar(const ClassifierContext& context) const {
  static const std::string none;
  if (context.asked != script::no_id && context.asked_slot != script::no_id)
    if (const auto& own =
            context_.topic(context.asked).slots[context.asked_slot].grammar;
        !own.empty())
      return own;
  const auto* state = context_.active_state();
  return state ? state->grammar : none;
}

// The words of the question that a yes or no would be for; null: none.
const std::string* TopicEngine::yes_or_no_asked() const {
  if (asked_)
    return asked_->wants_yes_or_no() ? &asked_->words : nullptr;
  const auto* confirm = latest_confirm();
  return confirm ? &confirm->question : nullptr;
}

Value TopicEngine::understanding_context() const {
  const auto context = classifier_context();
  auto name = [&](TopicId topic) {
    return topic == script::no_id ? Value() : Value(context_.topic(topic).name);
  };
  Map result;
  if (context.asked != script::no_id && context.asked_slot != script::no_id) {
    const auto& slot = context_.topic(context.asked).slots[context.asked_slot];
    result.set("asked",
               Map{{"topic", name(context.asked)}, {"slot", slot.name}});
    if (said_.topic == context.asked)
      result.set("said", names_said_before(context.asked_slot));
  }
  result.set("current", name(context.current));
  result.set("resting", name(context.resting));
  List unfinished;
  for (auto topic : context.unfinished)
    unfinished.push_back(name(topic));
  result.set("unfinished", unfinished);
  if (const auto& grammar = narrowing_grammar(context); !grammar.empty())
    result.set("grammar", grammar);
  if (const auto* question = yes_or_no_asked())
    result.set("confirms", *question);
  result.set("now", context_.now);
  return result;
}

} // namespace parlour::dialogue
