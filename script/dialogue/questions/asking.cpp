#include "script/dialogue/questions/asking.hpp"

#include <utility>

#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

// One without words counts as asked: silence after it ends somewhere.
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

void Asking::ask_slot(TopicId topic, SlotId slot, OutputAct as, TurnId turn) {
  const auto& state = frames_[topic].slots[slot];
  if (state.status == SlotStatus::unconfirmed) {
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
  auto code = question_wording(context_.topic(topic).slots[slot], state);
  put(std::move(asked), "question", {}, texts_.text_of(code, topic), as, turn);
}

void Asking::ask_confirmation(TopicId topic, SlotId slot, TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::confirmation;
  asked.topic = topic;
  asked.slot = slot;
  const auto& value = frames_[topic].slots[slot].value;
  put(std::move(asked), "confirm",
      words_.with_type(Map{{"value", value}}, topic, slot), {},
      OutputAct::question, turn);
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
