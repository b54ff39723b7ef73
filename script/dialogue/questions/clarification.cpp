#include "script/dialogue/questions/clarification.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "script/dialogue/topics/classifier.hpp"

namespace parlour::dialogue {

namespace {

// What was said, as it would be about this topic; null where it is not.
const Act* reading(const script::Program& program, const Act& said,
                   TopicId topic) {
  if (program.topic(said.topic) == topic)
    return &said;
  auto found = std::find_if(
      said.alternatives.begin(), said.alternatives.end(),
      [&](const Act& other) { return program.topic(other.topic) == topic; });
  return found == said.alternatives.end() ? nullptr : &*found;
}

// "To the airport." "Do you mean Taxi or Bus?" "The bus, at three.": the answer
// has topic and time, the earlier words the goal. What the answer says itself
// wins. The topic is settled now, so no alternatives are left to ask about.
void complete_from(const script::Program& program, const Act& said, Act& act) {
  const auto topic = program.topic(act.topic);
  const auto* meant =
      topic == script::no_id ? nullptr : reading(program, said, topic);
  if (!meant)
    return;
  for (const auto& value : meant->slots)
    if (std::none_of(
            act.slots.begin(), act.slots.end(),
            [&](const SlotValue& other) { return other.slot == value.slot; }))
      act.slots.push_back(value);
  act.kind = meant->kind;
  act.alternatives.clear();
}

} // namespace

bool Clarification::ask_which(const steps::Fill& step) {
  if (step.act->alternatives.empty() ||
      clarify(*context_.program, *step.act, whereabouts_.classifier_context())
          .empty())
    return false;
  Asked asked;
  asked.purpose = Asked::For::which_topic;
  asked.act = step.act;
  ask_which_again(std::move(asked), OutputAct::question, step.turn);
  return true;
}

void Clarification::ask_which_again(Asked asked, OutputAct as, TurnId turn) {
  List names;
  for (auto topic : clarify(*context_.program, *asked.act,
                            whereabouts_.classifier_context()))
    names.push_back(called(topic));
  asking_.put(std::move(asked), "clarify", Map{{"topics", std::move(names)}},
              {}, as, turn);
}

Value Clarification::called(TopicId topic) const {
  auto label = words_.label_of(topic);
  return label.is_unknown() ? Value(context_.topic(topic).name) : label;
}

bool Clarification::asks_which() const {
  return question_ && question_->purpose == Asked::For::which_topic &&
         question_->heard;
}

bool Clarification::leaves_open_which(const Act& act) const {
  return asks_which() && act.kind == ActKind::confirm && act.topic.empty() &&
         act.slots.empty();
}

// Another topic, or a no, drops what was said.
void Clarification::complete_by_answer(steps::TopicAct& step) {
  if (!asks_which())
    return;
  const auto said = question_.take().act;
  auto act = *step.act;
  complete_from(*context_.program, *said, act);
  step.act = std::make_shared<const Act>(std::move(act));
}

} // namespace parlour::dialogue
