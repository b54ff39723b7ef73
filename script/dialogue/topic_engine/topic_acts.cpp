// The part of the topic engine for acts that are about the conversation
// itself: which <repair> says what is done about them (engine rule 5).
#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "script/dialogue/topics/questions.hpp"
#include "script/dialogue/topics/repairs.hpp"

namespace parlour::dialogue {

namespace {

// Those that the question which waits has a part in.
bool about_the_question(ActKind kind) {
  return kind == ActKind::help || kind == ActKind::explain ||
         kind == ActKind::options || kind == ActKind::rephrase ||
         kind == ActKind::person;
}

bool is_open(TopicStatus status) {
  return status == TopicStatus::active || status == TopicStatus::suspended;
}

} // namespace

bool TopicEngine::is_generic(const Act& act) const {
  switch (act.kind) {
  case ActKind::inform:
  case ActKind::request:
  case ActKind::correct:
    return false;
  case ActKind::confirm:
  case ActKind::deny:
    return false; // for a slot, or to no question: not understood
  default:
    return act.slots.empty();
  }
}

void TopicEngine::generic_act(const Step& step) {
  const auto kind = step.act->kind;
  Trouble trouble{.act = name_of(kind), .turn = step.turn};
  if (about_the_question(kind) && asked_ && asked_->heard) {
    trouble.topic = asked_->topic;
    trouble.slot = asked_->slot;
  } else if (kind == ActKind::cancel) {
    trouble.topic = step.topic == script::no_id ? to_cancel() : step.topic;
  }
  misses_ = 0;
  if (asked_ && kind != ActKind::repeat && !unsettled_)
    asked_->interrupted = true; // unless it is asked again
  if (!repair(trouble))
    misunderstood(step);
}

bool TopicEngine::repair(const Trouble& trouble) {
  Value data;
  auto holds = [&](CodeId condition) {
    auto value = runner_.evaluate(condition, {data}, trouble.topic);
    if (!value)
      context_.script_failed(value.error(), trouble.turn);
    return value && *value;
  };
  data = situation(trouble);
  const auto* found = choose_repair(
      *context_.program,
      {trouble.act, trouble.topic, trouble.slot, trouble.count}, holds);
  if (!found)
    return false;
  auto step = body_step(found->body, trouble.turn);
  step.topic = trouble.topic;
  step.slot = trouble.slot;
  step.matter().arguments = {std::move(data)};
  context_.reached(found->position);
  context_.lane.now({std::move(step)});
  return true;
}

// What a <repair> sees as `data`.
Value TopicEngine::situation(const Trouble& trouble) {
  Value explanation;
  Value choices = List{};
  if (trouble.slot != script::no_id) {
    const auto code =
        explain_wording(context_.topic(trouble.topic).slots[trouble.slot],
                        context_.frame(trouble.topic).slots[trouble.slot]);
    if (code != script::no_code)
      explanation = text_of(code, trouble.topic);
    choices = choices_of(trouble.topic, trouble.slot)["choices"];
  }
  return Map{{"asked", asked_ && (asked_->heard || asked_->pending)},
             {"count", static_cast<std::int64_t>(trouble.count)},
             {"misses", static_cast<std::int64_t>(misses_)},
             {"refused", trouble.refused},
             {"explanation", std::move(explanation)},
             {"choices", std::move(choices)},
             {"unfinished", unfinished_names()},
             {"status", trouble.topic == script::no_id ? Value()
                        : is_completing(trouble.topic)
                            ? name_of(TopicStatus::active)
                            : name_of(context_.frame(trouble.topic).status)}};
}

Value TopicEngine::data_of(const std::string& act, TopicId topic, SlotId slot) {
  if ((act == "help" || act == "choices") && slot != script::no_id)
    return choices_of(topic, slot);
  if (act == "bye")
    return Map{{"unfinished", unfinished_names()}};
  if (act == "greet" && asked_)
    return Map{{"asked", true}};
  return {};
}

void TopicEngine::repeat(TurnId turn) {
  if (output_.said_anything())
    output_.repeat_last(turn);
  else
    say("repeat_nothing", script::no_id, script::no_id, {}, turn);
}

// A correction while nothing is going on is about what was completed last, as
// long as that is fresh.
bool TopicEngine::corrects_what_is_done(const Step& step) {
  const auto latest = context_.order.latest();
  const auto& sessions = context_.program->settings.sessions;
  if (step.act->kind != ActKind::correct || step.act->slots.empty() ||
      context_.order.current() || !latest ||
      context_.frame(*latest).status != TopicStatus::completed ||
      is_completing(*latest) ||
      context_.now - completed_at_ >= sessions.context_for.count())
    return false;
  for (const auto& value : step.act->slots)
    if (context_.topic(*latest).slot(value.slot) == script::no_id)
      return false;
  late_ = *step.act;
  late_->topic = context_.topic(*latest).name;
  return repair({.act = "correct", .topic = *latest, .turn = step.turn});
}

// -- ending topics ------------------------------------------------------------

// A <confirm> that is no topic's is all that is cancelled then.
TopicId TopicEngine::to_cancel() const {
  if (asked_ && (asked_->topic != script::no_id || asked_->wait != 0))
    return asked_->topic;
  if (auto current = context_.order.current())
    return *current;
  if (const auto topic = completing(); topic != script::no_id)
    return topic;
  const auto& suspended = context_.order.suspended();
  return suspended.empty() ? script::no_id : suspended.front();
}

bool TopicEngine::can_be_cancelled(TopicId topic) const {
  return is_open(context_.frame(topic).status) || is_completing(topic);
}

// What waits is ended first, so that a <catch> still sees its topic.
void TopicEngine::cancel(Step& step) {
  auto topics = std::vector{step.topic};
  if (step.mark != 0)
    topics = unfinished();
  else if (step.topic == script::no_id)
    topics = {to_cancel()};
  std::erase_if(topics, [&](TopicId topic) {
    return topic == script::no_id || !can_be_cancelled(topic);
  });
  output_.withdraw_questions();
  asked_.reset();
  auto steps = cancel_waits(step.mark != 0 ? std::vector<WaitId>()
                                           : confirms_but_of(topics));
  pushed_states_.clear_pushed();
  for (auto topic : topics) {
    auto ending = topic_step(StepKind::cancel_topic, topic);
    ending.turn = step.turn;
    ending.mark = topics.size() > 1;
    steps.push_back(std::move(ending));
  }
  if (topics.size() > 1)
    say("cancelled_all", script::no_id, script::no_id, {}, step.turn);
  else if (topics.empty())
    say("cancelled", script::no_id, script::no_id, {}, step.turn);
  context_.lane.now(std::move(steps));
}

// `mark`: it is one of several, of which one word is enough.
void TopicEngine::cancel_topic(Step& step) {
  auto steps = end_confirms_of(step.topic);
  if (asked_ && asked_->topic == step.topic) {
    output_.withdraw_questions();
    asked_.reset();
  }
  change(step.topic, {.kind = FrameChange::Kind::reset});
  set_status(step.topic, TopicStatus::cancelled);
  context_.order.completed(step.topic);
  if (step.mark == 0)
    say("cancelled", step.topic, script::no_id, {}, step.turn);
  run_body(context_.topic(step.topic).cancelled, step.topic, script::no_id,
           step.turn, steps);
  context_.lane.now(std::move(steps));
}

std::vector<TopicId> TopicEngine::unfinished() const {
  auto topics = context_.order.suspended();
  if (auto current = context_.order.current();
      current && context_.order.unfinished(*current))
    topics.insert(topics.begin(), *current);
  if (const auto topic = completing(); topic != script::no_id)
    topics.insert(topics.begin(), topic);
  return topics;
}

List TopicEngine::unfinished_names() const {
  List names;
  for (auto topic : unfinished())
    names.emplace_back(context_.topic(topic).name);
  return names;
}

void TopicEngine::restart() {
  output_.withdraw_questions();
  asked_.reset();
  late_.reset();
  said_ = {};
  query_.reset();
  no_input_ = 0;
  misses_ = 0;
  for (TopicId topic = 0; topic < context_.program->topics.size(); ++topic)
    if (context_.frame(topic).status != TopicStatus::untouched)
      change(topic, {.kind = FrameChange::Kind::reset});
  context_.order = TopicOrder(*context_.program);
}

} // namespace parlour::dialogue
