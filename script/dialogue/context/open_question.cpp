#include "script/dialogue/context/open_question.hpp"

#include <algorithm>

#include "runtime/text/words.hpp"

namespace parlour::dialogue {

// The slot counts as asked for when its question leaves, not when it is made:
// one that was withdrawn comes again in the same wording (engine rule 3.5).
void OpenQuestion::released(const Output& output) {
  if (output.topic != script::no_id)
    unmark(output.topic);
  if (!asked_ || asked_->output != output.id)
    return;
  asked_->pending = false;
  asked_->heard = true;
  asked_->words = output.text;
  if (asked_->slot == script::no_id || asked_->repeats ||
      !asked_->asks_for_value())
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

// One that was heard well enough stays as it is: it can be answered already.
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
// slot that it would ask for now. A topic of system initiative takes this slot
// only (engine rule 5.3).
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
