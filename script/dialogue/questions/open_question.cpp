#include "script/dialogue/questions/open_question.hpp"

#include <algorithm>

#include "runtime/text/words.hpp"
#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

void OpenQuestion::put(Asked&& asked, const char* act, Value data,
                       std::string text, OutputAct as, TurnId turn) {
  Say what;
  what.as = as;
  what.act = act;
  what.topic = asked.topic;
  what.slot = asked.slot;
  what.data = words_.with_marks(asked.topic, std::move(data));
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

void OpenQuestion::ask_slot(TopicId topic, SlotId slot, OutputAct as,
                            TurnId turn) {
  const auto& state = frames_[topic].slots[slot];
  if (state.status == SlotStatus::unconfirmed) {
    ask_confirmation(topic, slot, turn);
    return;
  }
  if (state.status == SlotStatus::ambiguous) {
    ask_choice(topic, slot, turn, true);
    return;
  }
  Asked asked;
  asked.topic = topic;
  asked.slot = slot;
  auto code = question_wording(context_.topic(topic).slots[slot], state);
  put(std::move(asked), "question", {}, words_.text_of(code, topic), as, turn);
}

void OpenQuestion::ask_confirmation(TopicId topic, SlotId slot, TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::confirmation;
  asked.topic = topic;
  asked.slot = slot;
  const auto& value = frames_[topic].slots[slot].value;
  put(std::move(asked), "confirm",
      words_.with_type(Map{{"value", value}}, topic, slot), {},
      OutputAct::question, turn);
}

// Several candidates: the slot's <ambiguous> asks, or "Do you mean A or B?".
void OpenQuestion::ask_choice(TopicId topic, SlotId slot, TurnId turn,
                              bool aloud) {
  Asked asked;
  asked.purpose = Asked::For::choice;
  asked.topic = topic;
  asked.slot = slot;
  const auto& state = frames_[topic].slots[slot];
  if (aloud) {
    put(std::move(asked), "ambiguous",
        words_.with_type(
            Map{{"candidates", state.candidates}, {"text", state.text}}, topic,
            slot),
        {}, OutputAct::question, turn);
    return;
  }
  asked.heard = true; // by the script's own words
  asked.pending = false;
  asked_ = std::move(asked);
}

void OpenQuestion::released(const Output& output) {
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
  frames_.count_question(asked_->topic, asked_->slot);
}

void OpenQuestion::withdrawn(const Output& output) {
  if (asked_ && asked_->output == output.id)
    asked_->pending = false;
}

// A question without words counts as asked: silence after it ends somewhere.
void OpenQuestion::unspoken(OutputId output) {
  if (!asked_ || !asked_->pending || asked_->output != output)
    return;
  asked_->pending = false;
  asked_->heard = true;
}

// Whoever has not heard half of it does not know what he says yes to.
void OpenQuestion::broken_off(const Output& output, const std::string& heard) {
  if (asked_ && asked_->output == output.id && asked_->wants_yes_or_no() &&
      2 * split_words(heard).size() < split_words(output.text).size())
    asked_->heard = false;
}

void OpenQuestion::said_again(OutputId before, OutputId now) {
  if (!asked_ || asked_->output != before || asked_->heard)
    return;
  asked_->output = now;
  asked_->pending = true;
}

// The marked values were in an output.
void OpenQuestion::unmark(TopicId topic) {
  const auto& slots = frames_[topic].slots;
  if (std::any_of(slots.begin(), slots.end(),
                  [](const SlotState& slot) { return slot.implicit; }))
    frames_.change(topic, {.kind = FrameChange::Kind::echoed});
}

bool OpenQuestion::asks_in_private() const {
  if (!asked_ || asked_->topic == script::no_id)
    return false;
  const auto& slots = context_.topic(asked_->topic).slots;
  return (asked_->slot < slots.size() && slots[asked_->slot].is_private) ||
         (asked_->about < slots.size() && slots[asked_->about].is_private);
}

bool OpenQuestion::asked_here() const {
  return asked_ && asked_->level == context_.states.levels().size();
}

// Also where others have said something since: of a topic that was begun, the
// slot that it would ask for now.
SlotId OpenQuestion::slot_asked_for(TopicId topic) const {
  if (asked_ && asked_->topic == topic)
    return asked_->slot;
  const auto status = frames_[topic].status;
  if (status != TopicStatus::active && status != TopicStatus::suspended)
    return script::no_id;
  const auto slot = frames_.doubtful(topic);
  return slot == script::no_id ? frames_.missing(topic) : slot;
}

} // namespace parlour::dialogue
