#include "script/dialogue/questions/asking.hpp"

#include <utility>

#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

// One without words counts as asked: silence after it ends somewhere, while a
// question that is never released would wait for ever.
void Asking::put(Asked&& asked, const char* act, Value data, std::string text,
                 OutputAct as, TurnId turn) {
  Say what;
  what.as = as;
  what.act = act;
  what.topic = asked.topic;
  what.slot = asked.slot;
  what.data = words_.with_marks(asked.topic, std::move(data));
  what.text = std::move(text);
  what.turn = asked.turn = turn;
  what.awaited = asked.wait != 0;
  asked.level = context_.states.levels().size();
  asked.output = output_.say(std::move(what));
  asked.pending = asked.output != 0;
  asked.heard = !asked.pending;
  question_.set(std::move(asked));
}

// What the slot is decides what is asked: a value in doubt, or an offer, wants
// a yes; candidates want a choice; everything else wants a value. The purpose
// then decides what a bare "yes" means: nothing, the slot's value (`boolean`),
// or "there is more" (`many`).
void Asking::ask_slot(TopicId topic, SlotId slot, OutputAct as, TurnId turn) {
  if (begin_part(topic, slot, turn))
    return;
  const bool offers = make_offer(topic, slot);
  const auto& state = frames_[topic].slots[slot];
  if (offers || state.status == SlotStatus::unconfirmed) {
    ask_confirmation(topic, slot, turn);
    return;
  }
  if (state.status == SlotStatus::ambiguous) {
    ask_choice(topic, slot, turn);
    return;
  }
  Asked asked;
  asked.topic = topic;
  asked.slot = slot;
  const auto& definition = context_.topic(topic).slots[slot];
  if (definition.cardinality.type == "boolean")
    asked.purpose = Asked::For::truth;
  if (asks_for_more(definition, state))
    asked.purpose = Asked::For::more;
  auto code = question_wording(definition, state);
  auto data = question_data(asked);
  put(std::move(asked), "question", std::move(data),
      texts_.text_of(code, topic), as, turn);
}

Value Asking::question_data(const Asked& asked) const {
  const auto data = words_.with_label({}, asked.topic, asked.slot);
  return data.empty() ? Value() : Value(data);
}

// Nothing is asked for a slot that a topic of its own fills: it begins.
bool Asking::begin_part(TopicId topic, SlotId slot, TurnId turn) {
  const auto& definition = context_.topic(topic).slots[slot];
  if (definition.part == script::no_id ||
      frames_[topic].slots[slot].status != SlotStatus::empty)
    return false;
  steps::Part part{topic, slot, turn};
  if (definition.with != script::no_code)
    part.with = texts_.value_of(definition.with, topic);
  context_.lane.at_once(std::move(part));
  return true;
}

// The first time, before the question: what the slot has to offer. The frame
// takes the value only if the slot's cardinality does, so an offer that does
// not fit is passed over, and the question comes as usual.
bool Asking::make_offer(TopicId topic, SlotId slot) {
  const auto offer = context_.topic(topic).slots[slot].offer;
  const auto& state = frames_[topic].slots[slot];
  if (offer == script::no_code || state.offered || state.asked > 0 ||
      state.status != SlotStatus::empty)
    return false;
  auto value = texts_.value_of(offer, topic);
  if (!value.is_unknown())
    frames_.change(topic, {.kind = FrameChange::Kind::offer,
                           .slot = slot,
                           .value = std::move(value)});
  return frames_[topic].slots[slot].status == SlotStatus::unconfirmed;
}

// An offer that nobody has said yet has neither words nor confidence. "Is the
// station all right?" is asked then, and not "Did you say the station?".
void Asking::ask_confirmation(TopicId topic, SlotId slot, TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::confirmation;
  asked.topic = topic;
  asked.slot = slot;
  const auto& state = frames_[topic].slots[slot];
  const bool is_offer =
      state.offered && state.text.empty() && state.confidence.is_unknown();
  put(std::move(asked), is_offer ? "offer" : "confirm",
      words_.with_type(
          words_.with_label(Map{{"value", state.value}}, topic, slot), topic,
          slot),
      {}, OutputAct::question, turn);
}

void Asking::ask_summary(Asked&& asked, OutputAct as, TurnId turn) {
  auto data =
      words_.with_label(Map{{"slots", words_.told(asked.topic)}}, asked.topic);
  put(std::move(asked), "summary", std::move(data), {}, as, turn);
}

void Asking::ask_change(Asked&& asked, OutputAct as, TurnId turn) {
  asked.purpose = Asked::For::change;
  auto data = Map{{"slots", words_.told(asked.topic)}};
  put(std::move(asked), "what_to_change", std::move(data), {}, as, turn);
}

// Several candidates: "Do you mean A or B?"
void Asking::ask_choice(TopicId topic, SlotId slot, TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::choice;
  asked.topic = topic;
  asked.slot = slot;
  const auto& state = frames_[topic].slots[slot];
  put(std::move(asked), "ambiguous",
      words_.with_type(
          Map{{"candidates", state.candidates}, {"text", state.text}}, topic,
          slot),
      {}, OutputAct::question, turn);
}

} // namespace parlour::dialogue
