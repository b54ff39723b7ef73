#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

namespace {

using script::no_code;

CodeId in_turn(const std::vector<CodeId>& texts, std::uint32_t turn) {
  return texts.empty() ? no_code : texts[turn % texts.size()];
}

} // namespace

bool asks_for_more(const script::Slot& slot, const SlotState& state) {
  return is_open(slot, state) && !state.wants_more;
}

CodeId question_wording(const script::Slot& slot, const SlotState& state) {
  if (asks_for_more(slot, state))
    return slot.more;
  if (slot.question == no_code)
    return in_turn(slot.help, state.asked);
  if (state.asked == 0 || slot.help.empty())
    return slot.question;
  return in_turn(slot.help, state.asked - 1);
}

CodeId explain_wording(const script::Slot& slot, const SlotState& state) {
  return in_turn(slot.explain, state.asked == 0 ? 0 : state.asked - 1);
}

CodeId counted_body(const std::vector<script::CountedBody>& bodies,
                    std::uint32_t count) {
  const script::CountedBody* due = nullptr;
  for (const auto& body : bodies)
    if (body.count <= count && (!due || body.count >= due->count))
      due = &body;
  return due ? due->body : no_code;
}

} // namespace parlour::dialogue
