// The part of the topic engine for what may be about several topics: which one
// is meant is asked for (understanding, "Score").
#include <algorithm>
#include <memory>
#include <utility>

#include "script/dialogue/topic_engine/topic_engine.hpp"

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

bool TopicEngine::ask_which(const Step& step) {
  if (step.act->alternatives.empty() ||
      clarify(*context_.program, *step.act, classifier_context()).empty())
    return false;
  Asked asked;
  asked.purpose = Asked::For::which_topic;
  asked.act = step.act;
  ask_which_again(std::move(asked), OutputAct::question, step.turn);
  return true;
}

void TopicEngine::ask_which_again(Asked asked, OutputAct as, TurnId turn) {
  List names;
  for (auto topic :
       clarify(*context_.program, *asked.act, classifier_context()))
    names.emplace_back(context_.topic(topic).name);
  put(std::move(asked), "clarify", Map{{"topics", std::move(names)}}, {}, as,
      turn);
}

bool TopicEngine::asks_which() const {
  return asked_ && asked_->purpose == Asked::For::which_topic && asked_->heard;
}

// "Do you mean A or B?" "Yes.": neither; but "yes, A" is an answer.
bool TopicEngine::leaves_open_which(const Step& step) {
  const auto& act = *step.act;
  if (!asks_which() || act.kind != ActKind::confirm || !act.topic.empty() ||
      !act.slots.empty())
    return false;
  const auto& ahead = context_.lane.ahead();
  const bool says_more =
      std::any_of(ahead.begin(), ahead.end(), [](const Step& other) {
        return other.kind == StepKind::take_act;
      });
  if (!says_more)
    misunderstood(step);
  return true;
}

// Another topic, or a no, drops what was said.
void TopicEngine::complete_by_answer(Step& step) {
  if (!asks_which())
    return;
  const auto said = std::exchange(asked_, {})->act;
  auto act = *step.act;
  complete_from(*context_.program, *said, act);
  step.act = std::make_shared<const Act>(std::move(act));
}

} // namespace parlour::dialogue
