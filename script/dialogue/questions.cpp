#include "script/dialogue/questions.hpp"

#include <algorithm>
#include <array>

namespace parlour::dialogue {

namespace {

using script::no_code;

constexpr std::array ladder_names = {
#define X(name, sentence) std::string_view(#name),
    PARLOUR_LADDER_STEPS(X)
#undef X
};

CodeId in_turn(const std::vector<CodeId>& texts, std::uint32_t turn) {
  return texts.empty() ? no_code : texts[turn % texts.size()];
}

bool can_take(const script::Slot& slot, LadderStep step) {
  if (step == LadderStep::explain)
    return !slot.explain.empty();
  if (step == LadderStep::offer_choices)
    return !slot.cardinality.values.empty();
  return true;
}

} // namespace

CodeId question_wording(const script::Slot& slot, const SlotState& state) {
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

std::string_view name_of(LadderStep step) {
  return ladder_names[static_cast<std::size_t>(step)];
}

LadderStep ladder_step(std::uint32_t count) {
  const auto last = static_cast<std::uint32_t>(ladder_names.size() - 1);
  return static_cast<LadderStep>(std::min(count == 0 ? 0 : count - 1, last));
}

LadderStep ladder_step(const script::Slot& slot, std::uint32_t count) {
  auto step = ladder_step(count);
  return can_take(slot, step) ? step : LadderStep::rephrase;
}

} // namespace parlour::dialogue
