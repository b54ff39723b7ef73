// The part of the topic engine that asks: for slots, for a choice, for a yes
// (engine rules 3 and 5).
#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "script/dialogue/topics/questions.hpp"
#include "script/program/constant_text.hpp"

namespace parlour::dialogue {

// -- which question -----------------------------------------------------------

void TopicEngine::conclude(Step& step) {
  if (context_.lane.returning()) // what waited for this goes on, and concludes
    return;
  if (asked_ && (asked_->heard || asked_->pending))
    return;
  ask_what_misses(OutputAct::question, step.turn);
  acknowledge_unasked(step.turn);
}

void TopicEngine::ask_next(Step& step) {
  ask_what_misses(step.output, step.turn);
}

void TopicEngine::ask_what_misses(OutputAct as, TurnId turn) {
  auto current = context_.order.current();
  if (context_.ending || !current || waits_for_user(*current))
    return;
  if (auto slot = to_ask(*current); slot != script::no_id)
    ask_slot(*current, slot, as, turn);
}

// Whether the topic must not ask: while it waits for a yes, or in a subtask,
// unless that is where the user has begun it.
bool TopicEngine::waits_for_user(TopicId topic) const {
  const bool begun = spoken_of_.topic == topic && spoken_of_.turn == turn_ &&
                     !pushed_states_.was_pushed_by(topic);
  return (context_.states.pushed() && !begun) || wants_a_yes(topic);
}

// What is in doubt must be settled in any case; what is missing is asked for
// where the topic asks at all.
SlotId TopicEngine::to_ask(TopicId topic) const {
  const auto& definition = context_.topic(topic);
  if (context_.frame(topic).status != TopicStatus::active)
    return script::no_id;
  if (auto slot = doubtful(topic); slot != script::no_id)
    return slot;
  return definition.kind == script::TopicKind::task && may_ask(topic)
             ? missing(topic)
             : script::no_id;
}

// One that leaves the lead to the user never asks (engine rule 5).
bool TopicEngine::may_ask(TopicId topic) const {
  return context_.topic(topic).initiative != script::Initiative::user;
}

void TopicEngine::acknowledge_unasked(TurnId turn) {
  const auto current = context_.order.current();
  if (turn == 0 || turn != turn_ || output_.spoken() != said_before_ ||
      !current || may_ask(*current) || context_.ending ||
      waits_for_user(*current) ||
      context_.frame(*current).status != TopicStatus::active)
    return;
  const auto slot = missing(*current);
  if (slot != script::no_id)
    say("acknowledge", *current, script::no_id,
        Map{{"missing", context_.topic(*current).slots[slot].name}}, turn);
}

void TopicEngine::ask(Step& step) {
  if (step.slot != script::no_id)
    ask_slot(step.topic, step.slot, step.output, step.turn);
  else if (const auto* confirm = latest_confirm()) {
    asked_ = *confirm;
    repeat_question(step.turn);
  }
}

void TopicEngine::ask_slot(TopicId topic, SlotId slot, OutputAct as,
                           TurnId turn) {
  const auto& state = context_.frame(topic).slots[slot];
  if (state.status == SlotStatus::unconfirmed) {
    ask_confirmation(topic, slot, turn);
    return;
  }
  if (state.status == SlotStatus::ambiguous) {
    ask_choice(topic, slot, turn, true);
    return;
  }
  if (climb_after_refusal(topic, slot, turn))
    return;
  Asked asked;
  asked.topic = topic;
  asked.slot = slot;
  auto code = question_wording(context_.topic(topic).slots[slot], state);
  put(std::move(asked), "question", {}, text_of(code, topic), as, turn);
}

// How its values are said.
Value TopicEngine::with_type(Map data, TopicId topic, SlotId slot) const {
  const auto& type = context_.topic(topic).slots[slot].cardinality.type;
  if (!type.empty())
    data.set("type", type);
  return data;
}

bool TopicEngine::asks_in_private() const {
  if (!asked_ || asked_->topic == script::no_id)
    return false;
  const auto& slots = context_.topic(asked_->topic).slots;
  return (asked_->slot < slots.size() && slots[asked_->slot].is_private) ||
         (asked_->about < slots.size() && slots[asked_->about].is_private);
}

void TopicEngine::ask_confirmation(TopicId topic, SlotId slot, TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::confirmation;
  asked.topic = topic;
  asked.slot = slot;
  const auto& value = context_.frame(topic).slots[slot].value;
  put(std::move(asked), "confirm",
      with_type(Map{{"value", value}}, topic, slot), {}, OutputAct::question,
      turn);
}

// Several candidates: the slot's <ambiguous> asks, or "Do you mean A or B?".
void TopicEngine::ask_choice(TopicId topic, SlotId slot, TurnId turn,
                             bool aloud) {
  Asked asked;
  asked.purpose = Asked::For::choice;
  asked.topic = topic;
  asked.slot = slot;
  const auto& state = context_.frame(topic).slots[slot];
  if (aloud) {
    put(std::move(asked), "ambiguous",
        with_type(Map{{"candidates", state.candidates}, {"text", state.text}},
                  topic, slot),
        {}, OutputAct::question, turn);
    return;
  }
  asked.heard = true; // by the script's own words
  asked.pending = false;
  asked_ = std::move(asked);
}

void TopicEngine::put(Asked&& asked, const char* act, Value data,
                      std::string text, OutputAct as, TurnId turn) {
  Say what;
  what.as = as;
  what.act = act;
  what.topic = asked.topic;
  what.slot = asked.slot;
  what.data = with_marks(asked.topic, std::move(data));
  what.text = std::move(text);
  what.turn = asked.turn = turn;
  asked.level = context_.states.levels().size();
  what.awaited = asked.wait != 0;
  asked.heard = false;
  asked.pending = true;
  asked_ = std::move(asked);
  asked_->output = output_.say(std::move(what));
  if (asked_->output == 0)
    unspoken(0);
}

std::string TopicEngine::text_of(CodeId code, TopicId topic) {
  if (code == script::no_code)
    return {};
  if (auto constant = script::constant_text(*context_.program, code))
    return std::string(*constant);
  auto text = runner_.evaluate(code, {}, topic);
  if (text)
    return text->text();
  context_.inspect(InspectionKind::error, context_.topic(topic).name,
                   to_string(text.error()));
  return {};
}

// -- what became of it --------------------------------------------------------

void TopicEngine::released(const Output& output) {
  if (output.topic != script::no_id)
    unmark(output.topic);
  if (!asked_ || asked_->output != output.id)
    return;
  asked_->pending = false;
  asked_->heard = true;
  asked_->words = output.text;
  if (asked_->slot == script::no_id || asked_->repeats ||
      asked_->purpose != Asked::For::value)
    return;
  context_.frames.count_question(asked_->topic, asked_->slot, context_.now);
}

// The marked values were in an output.
void TopicEngine::unmark(TopicId topic) {
  const auto& slots = context_.frame(topic).slots;
  if (std::any_of(slots.begin(), slots.end(),
                  [](const SlotState& slot) { return slot.implicit; }))
    change(topic, {.kind = FrameChange::Kind::echoed});
}

void TopicEngine::withdrawn(const Output& output) {
  if (asked_ && asked_->output == output.id)
    asked_->pending = false;
}

// A question without words counts as asked: silence after it ends somewhere.
void TopicEngine::unspoken(OutputId output) {
  if (!asked_ || !asked_->pending || asked_->output != output)
    return;
  asked_->pending = false;
  asked_->heard = true;
}

} // namespace parlour::dialogue
