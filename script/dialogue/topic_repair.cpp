// The part of the topic engine for questions that are not answered: asked again
// when nothing was understood or nobody said anything, up a ladder (engine rule
// 5).
#include <algorithm>
#include <utility>

#include "script/dialogue/core.hpp"
#include "script/dialogue/questions.hpp"
#include "script/dialogue/steps.hpp"

namespace parlour::dialogue {

void TopicEngine::no_match(Step& step) {
  core_.turns.taken_up(step.turn);
  core_.turns.let_go(step.turn);
  no_input_ = 0;
  misunderstood(std::move(step));
}

void TopicEngine::misunderstood(Step step) {
  auto heard = step.act ? step.act->text : std::string();
  offer("no_match", std::move(heard),
        make_step(StepKind::not_understood, std::move(step)));
}

void TopicEngine::not_understood(Step& step) {
  if (!consumed(step.offered))
    not_understood(step.turn, step.mark == 0);
}

void TopicEngine::not_understood(TurnId turn, bool apologise) {
  if (asked_ && asked_->heard) {
    reprompt(turn, true);
    return;
  }
  ++misses_;
  if (apologise && !repair({.act = "no_match", .turn = turn}))
    say("no_match", script::no_id, script::no_id, {}, turn);
}

void TopicEngine::no_input(Step& step) {
  if (!consumed(step.offered) && asked_ && asked_->heard)
    reprompt(step.turn, false);
}

// The slot's own <nomatch> or <noinput>, the settings' <ladder>, else the
// <repair> for it.
void TopicEngine::reprompt(TurnId turn, bool heard_something) {
  const auto times = count_miss(heard_something);
  const auto topic = asked_->topic;
  const auto slot = asked_->slot;
  if (slot != script::no_id && run_own_words(heard_something, times, turn))
    return;
  if (slot != script::no_id && !core_.program->ladder.empty()) {
    climb_own(topic, slot, times, turn);
    return;
  }
  const auto* act = heard_something ? "no_match" : "no_input";
  if (!repair({act, topic, slot, times, turn}))
    repeat_question(turn);
}

std::uint32_t TopicEngine::count_miss(bool heard_something) {
  if (asked_->slot == script::no_id)
    return ++asked_->missed;
  FrameChange count;
  count.kind = heard_something ? FrameChange::Kind::no_match
                               : FrameChange::Kind::no_input;
  count.slot = asked_->slot;
  change(asked_->topic, std::move(count));
  const auto& state = core_.frame(asked_->topic).slots[asked_->slot];
  return heard_something ? state.no_match : state.no_input;
}

bool TopicEngine::run_own_words(bool heard_something, std::uint32_t times,
                                TurnId turn) {
  const auto& definition = core_.topic(asked_->topic).slots[asked_->slot];
  auto body = counted_body(
      heard_something ? definition.no_match : definition.no_input, times);
  if (body == script::no_code)
    return false;
  std::vector<Step> steps;
  run_body(body, asked_->topic, asked_->slot, turn, steps);
  core_.lane.now(std::move(steps));
  return true;
}

// A step of the application's own ladder, then the question once more, unless
// the step has asked, cleared or left.
void TopicEngine::climb_own(TopicId topic, SlotId slot, std::uint32_t times,
                            TurnId turn) {
  const auto& ladder = core_.program->ladder;
  const auto last = ladder.size() - 1;
  std::vector<Step> steps;
  run_body(ladder[std::min<std::size_t>(times == 0 ? 0 : times - 1, last)],
           topic, slot, turn, steps);
  auto ask = topic_step(StepKind::ask_still, topic);
  ask.slot = slot;
  ask.turn = turn;
  ask.mark = redirections_;
  steps.push_back(std::move(ask));
  core_.lane.now(std::move(steps));
}

void TopicEngine::ask_still(Step& step) {
  if (step.mark == redirections_ && !core_.ending &&
      core_.frame(step.topic).status == TopicStatus::active &&
      core_.order.current() == step.topic)
    ask_slot(step.topic, step.slot, OutputAct::reprompt, step.turn);
}

Value TopicEngine::choices_of(TopicId topic, SlotId slot) {
  List choices;
  for (auto code : core_.topic(topic).slots[slot].cardinality.values)
    choices.emplace_back(text_of(code, topic));
  return Map{{"choices", choices}};
}

void TopicEngine::say_text(std::string text, TurnId turn) {
  if (text.empty())
    return;
  Say what;
  what.text = std::move(text);
  what.turn = turn;
  core_.mouth.say(std::move(what));
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
    auto state = core_.frame(asked.topic).slots[asked.slot];
    asked.repeats = true;
    state.asked = state.asked > 0 ? state.asked - 1 : 0; // the same wording
    auto code =
        question_wording(core_.topic(asked.topic).slots[asked.slot], state);
    const auto topic = asked.topic;
    put(std::move(asked), "question", {}, text_of(code, topic),
        OutputAct::reprompt, turn);
    return;
  }
  ask_slot(asked.topic, asked.slot, OutputAct::reprompt, turn);
}

} // namespace parlour::dialogue
