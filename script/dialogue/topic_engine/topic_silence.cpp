// The part of the topic engine for silence: what it leads to, and how
// unfinished topics are taken up again (engine rule 5, "Which topic next").
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

// Unanswered questions in a row after which the engine stops asking.
constexpr int most_reprompts = 5;

} // namespace

TopicEngine::Due TopicEngine::due() const {
  if (asked_ && asked_->heard && !asked_->interrupted)
    return no_input_ < most_reprompts ? Due::reprompt : Due::nothing;
  if (asked_)
    return asked_->pending ? Due::nothing : Due::again;
  if (!confirms_.empty())
    return Due::confirmation;
  if (context_.states.pushed())
    return state_listens() ? Due::state : Due::nothing;
  if (runner_.topic_waits()) // its script says when to go on
    return Due::nothing;
  auto current = context_.order.current();
  if (current && to_ask(*current) != script::no_id)
    return Due::question;
  if (context_.order.next())
    return Due::topic;
  return state_listens() ? Due::state : Due::nothing;
}

// The active state says what silence means where nothing is asked.
bool TopicEngine::state_listens() const {
  const auto state = context_.states.active();
  return state != script::no_id && no_input_ < most_reprompts &&
         listens_to_silence_[state];
}

std::optional<Milliseconds> TopicEngine::silence_wanted() const {
  const auto& settings = context_.program->settings.sessions;
  switch (due()) {
  case Due::nothing:
    return std::nullopt;
  case Due::reprompt:
  case Due::state:
    return settings.no_input_after;
  default:
    return settings.resume_after;
  }
}

void TopicEngine::silence() {
  output_.turn_begins();
  switch (due()) {
  case Due::nothing:
    return;
  case Due::reprompt:
  case Due::state:
    ++no_input_;
    offer("no_input", {}, make_step(StepKind::no_input, {}));
    return;
  case Due::again:
    ask_again();
    return;
  case Due::confirmation: {
    auto steps = back_to(confirms_.back().topic);
    steps.push_back(topic_step(StepKind::ask, confirms_.back().topic));
    context_.lane.queue(std::move(steps));
    return;
  }
  case Due::question: {
    const auto topic = *context_.order.current();
    ask_slot(topic, to_ask(topic), OutputAct::resume, 0);
    return;
  }
  case Due::topic:
    context_.lane.queue(
        {topic_step(StepKind::resume_topic, context_.order.next()->topic)});
  }
}

// The question that was withdrawn, unless a script has answered it meanwhile.
void TopicEngine::ask_again() {
  const auto asked = *asked_;
  if (asked.slot == script::no_id) {
    repeat_question(0);
    return;
  }
  asked_.reset();
  if (context_.frame(asked.topic).slots[asked.slot].status !=
      SlotStatus::filled)
    ask_slot(asked.topic, asked.slot, OutputAct::resume, 0);
}

// Back to an unfinished topic, or on to one of system initiative.
void TopicEngine::resume_topic(Step& step) {
  const bool suspended =
      context_.frame(step.topic).status == TopicStatus::suspended;
  if (suspended &&
      context_.topic(step.topic).resume == script::ResumePolicy::ask) {
    Asked asked;
    asked.purpose = Asked::For::resume;
    asked.topic = step.topic;
    put(std::move(asked), "resume", {}, {}, OutputAct::resume, 0);
    return;
  }
  take_up(step.topic);
}

void TopicEngine::answer_resume(TopicId topic, bool yes, TurnId turn) {
  if (yes) {
    take_up(topic);
    return;
  }
  Step cancel = topic_step(StepKind::cancel_topic, topic);
  cancel.turn = turn;
  context_.lane.now({std::move(cancel)});
}

void TopicEngine::take_up(TopicId topic) {
  StepList steps;
  begin_topic(topic, steps);
  steps.push_back(topic_step(StepKind::settle, topic));
  auto ask = topic_step(StepKind::ask_next, topic);
  ask.output = OutputAct::resume;
  steps.push_back(std::move(ask));
  context_.lane.now(std::move(steps));
}

} // namespace parlour::dialogue
