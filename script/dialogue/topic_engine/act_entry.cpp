#include "script/dialogue/topic_engine/act_entry.hpp"

#include <string>
#include <utility>

namespace parlour::dialogue {

// The order matters. Breath comes first: it may put a kept answer in front, and
// this step is then taken once more. Private values are noted before anybody is
// shown the act. In a pushed state the reactions come before the question, as
// the state may listen to "yes" for itself (engine rule 2.8).
void ActEntry::take(steps::TakeAct&& step) {
  if (breath_.joins(step))
    return;
  context_.turns.taken_up(step.turn);
  context_.turns.let_go(step.turn);
  silence_.user_spoke();
  reprompts_.act_begins();
  if (context_.privacy.is_needed())
    conceal_values(*step.act);
  next_question_.turn_begins(step.turn);
  if (context_.states.pushed() ||
      !yes_or_no_.answer_to_question(step.act, step.turn))
    offer_act({std::move(step.act), step.turn});
}

void ActEntry::take(const steps::NoMatch& step) {
  context_.turns.taken_up(step.turn);
  context_.turns.let_go(step.turn);
  silence_.user_spoke();
  breath_.forget(); // a yes with more than is understood
  reprompts_.misunderstood(step.turn, {}, step.apologised);
}

// The act becomes a map for the listeners alone. What the offer ends in, the
// act itself, travels as the step `otherwise`.
void ActEntry::offer_act(steps::TopicAct&& step) {
  const auto command = std::string(name_of(step.act->kind));
  const auto* state = context_.active_state();
  if (offers_.listens(command)) {
    auto parameter = to_value(*step.act); // which nobody else would read
    const auto offer = step.offer = offers_.next_offer();
    offers_.offer(command, std::move(parameter), offer, std::move(step));
  } else if (state && state->capture != script::Capture::none) {
    // The state keeps every act for itself; this one it has no use for, unless
    // it is to a question of its own.
    if (!question_.asked_here() ||
        !yes_or_no_.answer_to_question(step.act, step.turn))
      reprompts_.misunderstood(step.turn, step.act->text);
  } else {
    topic_acts_.take(std::move(step));
  }
}

// Before anybody is told of them, whatever becomes of the act. Where it names
// no topic, they may be any one's: the value counts as private if one topic has
// a private slot of that name. Rather too much is hidden than too little.
void ActEntry::conceal_values(const Act& act) {
  if (names_slot(act)) // that is no value
    return;
  const auto& topics = context_.program->topics;
  for (TopicId id = 0; id < topics.size(); ++id)
    for (const auto& said : act.slots) {
      const auto slot = topics[id].slot(said.slot);
      if (slot == script::no_id ||
          !(act.topic.empty() || topics[id].name == act.topic))
        continue;
      FrameChange change;
      change.slot = slot;
      change.value = said.value;
      change.candidates = said.candidates;
      change.text = said.text;
      context_.conceal(id, {&change, 1});
    }
  for (const auto& other : act.alternatives)
    conceal_values(other);
}

// "Yes" while a <confirm> waits; "cancel" always, as a wish to get out passes
// every wait (engine rule 2.5).
bool ActEntry::is_waited_for(const Act& act) const {
  if (passes_waits(act))
    return true;
  if (context_.states.pushed() && offers_.state_listens(name_of(act.kind)))
    return true;
  return confirmations_.any() && is_answer(act);
}

} // namespace parlour::dialogue
