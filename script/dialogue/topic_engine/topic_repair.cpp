// The part of the topic engine for questions that are not answered: asked again
// when nothing was understood or nobody said anything, up a ladder (engine rule
// 5).
#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

namespace {

// What a <repair> is for.
constexpr std::string_view not_matched = "no_match";
constexpr std::string_view not_said = "no_input";

} // namespace

void TopicEngine::no_match(Step& step) {
  context_.turns.taken_up(step.turn);
  context_.turns.let_go(step.turn);
  no_input_ = 0;
  unsettled_.reset(); // a yes with more than is understood
  misunderstood(std::move(step));
}

// Of what is said in one breath the last counts: that is what is dealt with.
void TopicEngine::misunderstood(Step step) {
  if (context_.turns.said_since(step.turn, context_.now))
    return;
  auto heard = step.act ? step.act->text : std::string();
  offer("no_match", std::move(heard),
        make_step(StepKind::not_understood, std::move(step)));
}

void TopicEngine::not_understood(Step& step) {
  if (!was_consumed(step))
    not_understood(step.turn, step.mark == 0);
}

void TopicEngine::not_understood(TurnId turn, bool apologise) {
  if (asked_ && asked_->heard) {
    reprompt(turn, true);
    return;
  }
  ++misses_;
  if (apologise && context_.apologies.due(context_.now) &&
      !repair({.act = "no_match", .turn = turn}))
    say("no_match", script::no_id, script::no_id, {}, turn);
}

void TopicEngine::no_input(Step& step) {
  if (!was_consumed(step) && asked_ && asked_->heard)
    reprompt(step.turn, false);
}

void TopicEngine::reprompt(TurnId turn, bool heard_something) {
  const auto times = count_miss(heard_something);
  climb({.act = heard_something ? not_matched : not_said,
         .topic = asked_->topic,
         .slot = asked_->slot,
         .count = times,
         .turn = turn});
}

// The slot's own <nomatch> or <noinput>, the settings' <ladder>, else the
// <repair> for it.
void TopicEngine::climb(const Trouble& trouble) {
  const bool of_slot = trouble.slot != script::no_id;
  if (of_slot && run_own_words(trouble))
    return;
  if (of_slot && !context_.program->ladder.empty())
    climb_own(trouble);
  else if (!repair(trouble))
    repeat_question(trouble.turn);
}

std::uint32_t TopicEngine::count_miss(bool heard_something) {
  if (asked_->slot == script::no_id)
    return ++asked_->missed;
  FrameChange count;
  count.kind = heard_something ? FrameChange::Kind::no_match
                               : FrameChange::Kind::no_input;
  count.slot = asked_->slot;
  change(asked_->topic, std::move(count));
  const auto& state = context_.frame(asked_->topic).slots[asked_->slot];
  return heard_something ? state.no_match : state.no_input;
}

void TopicEngine::count_refusal(TopicId topic, SlotId slot) {
  if (context_.frame(topic).slots[slot].asked == 0)
    return; // nobody had asked
  change(topic, {.kind = FrameChange::Kind::no_match, .slot = slot});
  refused_ = SlotOf{topic, slot};
}

// The first time, what does not fit was told, and the question comes as ever.
bool TopicEngine::climb_after_refusal(TopicId topic, SlotId slot, TurnId turn) {
  const bool refused =
      refused_ && refused_->topic == topic && refused_->slot == slot;
  const auto times = context_.frame(topic).slots[slot].no_match;
  if (!refused || times < 2)
    return false;
  refused_.reset();
  Asked asked;
  asked.topic = topic;
  asked.slot = slot;
  asked.pending = false;
  asked.heard = true;
  asked_ = std::move(asked);
  climb({.act = not_matched,
         .topic = topic,
         .slot = slot,
         .count = times,
         .turn = turn,
         .refused = true});
  return true;
}

bool TopicEngine::run_own_words(const Trouble& trouble) {
  const auto& definition = context_.topic(trouble.topic).slots[trouble.slot];
  auto body = counted_body(trouble.act == not_matched ? definition.no_match
                                                      : definition.no_input,
                           trouble.count);
  if (body == script::no_code)
    return false;
  StepList steps;
  run_body(body, trouble.topic, trouble.slot, trouble.turn, steps);
  context_.lane.now(std::move(steps));
  return true;
}

// A step of the application's own ladder, then the question once more, unless
// the step has asked, cleared or left.
void TopicEngine::climb_own(const Trouble& trouble) {
  const auto& ladder = context_.program->ladder;
  const auto last = ladder.size() - 1;
  const auto rung = trouble.count == 0 ? 0 : trouble.count - 1;
  const auto body = ladder[std::min<std::size_t>(rung, last)];
  StepList steps;
  run_body(body, trouble.topic, trouble.slot, trouble.turn, steps);
  auto ask = topic_step(StepKind::ask_still, trouble.topic);
  ask.slot = trouble.slot;
  ask.turn = trouble.turn;
  ask.code = body;
  steps.push_back(std::move(ask));
  context_.lane.now(std::move(steps));
}

void TopicEngine::ask_still(Step& step) {
  if (!runner_.redirected(step.code) && !context_.ending &&
      context_.frame(step.topic).status == TopicStatus::active &&
      context_.order.current() == step.topic)
    ask_slot(step.topic, step.slot, OutputAct::reprompt, step.turn);
}

// The values of a set; a range's bounds, as far as it has them.
Value TopicEngine::choices_of(TopicId topic, SlotId slot) {
  const auto& taken = context_.topic(topic).slots[slot].cardinality;
  List choices;
  for (auto code : taken.values)
    choices.emplace_back(text_of(code, topic));
  Map said{{"choices", std::move(choices)}};
  if (taken.minimum != script::no_code)
    said.set("from", text_of(taken.minimum, topic));
  if (taken.maximum != script::no_code)
    said.set("to", text_of(taken.maximum, topic));
  return said;
}

void TopicEngine::say_text(std::string text, TurnId turn) {
  if (text.empty())
    return;
  Say what;
  what.text = std::move(text);
  what.turn = turn;
  output_.say(std::move(what));
}

// `mark`: in the words that were heard, else in the next.
void TopicEngine::ask_again(Step& step) {
  if (!asked_)
    return;
  if (step.mark != 0 || asked_->purpose != Asked::For::value)
    repeat_question(step.turn);
  else
    ask_slot(asked_->topic, asked_->slot, OutputAct::reprompt, step.turn);
}

void TopicEngine::repeat_question(TurnId turn) {
  auto asked = *asked_;
  asked.interrupted = false;
  if (asked.purpose == Asked::For::yes_or_no) {
    auto text = asked.question;
    put(std::move(asked), "confirm", {}, std::move(text), OutputAct::reprompt,
        turn);
    return;
  }
  if (asked.purpose == Asked::For::which_topic) {
    ask_which_again(std::move(asked), OutputAct::reprompt, turn);
    return;
  }
  if (asked.purpose == Asked::For::resume) {
    put(std::move(asked), "resume", {}, {}, OutputAct::reprompt, turn);
    return;
  }
  if (asked.slot != script::no_id && asked.purpose == Asked::For::value) {
    auto state = context_.frame(asked.topic).slots[asked.slot];
    asked.repeats = true;
    state.asked = state.asked > 0 ? state.asked - 1 : 0; // the same wording
    auto code =
        question_wording(context_.topic(asked.topic).slots[asked.slot], state);
    const auto topic = asked.topic;
    put(std::move(asked), "question", {}, text_of(code, topic),
        OutputAct::reprompt, turn);
    return;
  }
  ask_slot(asked.topic, asked.slot, OutputAct::reprompt, turn);
}

} // namespace parlour::dialogue
