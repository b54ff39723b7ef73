#include "script/dialogue/questions/repair_runner.hpp"

#include <utility>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/topics/questions.hpp"
#include "script/dialogue/topics/repairs.hpp"

namespace parlour::dialogue {

// `holds` refers to `data`, which is filled before it is called.
bool RepairRunner::repair(const Trouble& trouble) {
  Value data;
  auto holds = [&](CodeId condition) {
    return texts_.holds(condition, {data}, trouble.topic, trouble.turn);
  };
  data = situation(trouble);
  const auto* found = choose_repair(
      *context_.program,
      {trouble.act, trouble.topic, trouble.slot, trouble.count}, holds);
  if (!found)
    return false;
  context_.reached(found->position);
  context_.lane.at_once(
      steps::Run{{.code = found->body,
                  .topic = trouble.topic,
                  .slot = trouble.slot,
                  .turn = trouble.turn,
                  .input = input_of(std::vector{std::move(data)})}});
  return true;
}

// What a <repair> sees as `data`.
Value RepairRunner::situation(const Trouble& trouble) {
  Value explanation;
  Value choices = List{};
  if (trouble.slot != script::no_id) {
    const auto code =
        explain_wording(context_.topic(trouble.topic).slots[trouble.slot],
                        frames_[trouble.topic].slots[trouble.slot]);
    if (code != script::no_code)
      explanation = texts_.text_of(code, trouble.topic);
    choices = texts_.choices_of(trouble.topic, trouble.slot)["choices"];
  }
  const bool asked = question_ && (question_->heard || question_->pending);
  return Map{
      {"asked", asked},
      {"confirms", asked && question_->wants_yes_or_no() && !trouble.answered},
      {"count", static_cast<std::int64_t>(trouble.count)},
      {"misses", static_cast<std::int64_t>(misses_)},
      {"refused", trouble.refused},
      {"explanation", std::move(explanation)},
      {"choices", std::move(choices)},
      {"unfinished", whereabouts_.unfinished_names()},
      {"status", whereabouts_.status_of(trouble.topic)}};
}

Value RepairRunner::data_of(const std::string& act, TopicId topic,
                            SlotId slot) {
  if ((act == "help" || act == "choices") && slot != script::no_id)
    return texts_.choices_of(topic, slot);
  if (act == "bye")
    return Map{{"unfinished", whereabouts_.unfinished_names()}};
  if ((act == "greet" || act == "refuse") && question_)
    return Map{{"asked", true}};
  return {};
}

} // namespace parlour::dialogue
