// The part of the topic engine for a script's <confirm>: it is asked, asked
// anew, and ended without an answer (language rule 12.20).
#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

// What comes of a topic when its scripts have run.
bool concludes(StepKind kind) {
  return kind == StepKind::settle || kind == StepKind::finish ||
         kind == StepKind::wind_up || kind == StepKind::answer;
}

} // namespace

// -- asking -------------------------------------------------------------------

void TopicEngine::confirm(std::string question, TopicId topic, SlotId slot,
                          WaitId wait, TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::yes_or_no;
  asked.topic = topic;
  asked.about = slot;
  asked.wait = wait;
  asked.body = runner_.body();
  asked.question = question;
  asked.level = context_.states.levels().size();
  asked.pending = false;
  asked.heard = true; // as soon as it comes to that
  note_question_before(asked, turn);
  confirms_.push_back(asked);
  put(std::move(asked), "confirm", {}, std::move(question), OutputAct::question,
      turn);
}

// Who asks about the same words again has not answered that either.
void TopicEngine::note_question_before(Asked& asked, TurnId turn) const {
  if (asked.topic != script::no_id || turn == 0 || !asked_ || !asked_->heard)
    return;
  const bool again = asked_->wait != 0 && asked_->body == asked.body;
  asked.before =
      again ? asked_->before : std::make_shared<const Asked>(*asked_);
}

// A handler's, as the words that it asked about may answer that.
void TopicEngine::back_to_question_before(const Asked& asked) {
  if (!asked.before || context_.lane.waits(asked.wait) ||
      !may_be_answered(*asked.before))
    return;
  asked_ = *asked.before;
  asked_->interrupted |= !asked_->wants_yes_or_no(); // it comes again, if not
}

bool TopicEngine::may_be_answered(const Asked& asked) const {
  if (asked.wait != 0)
    return std::ranges::any_of(confirms_, [&](const Asked& confirm) {
      return confirm.wait == asked.wait && !confirm.anew;
    });
  if (asked.slot == script::no_id)
    return asked.topic == script::no_id ||
           context_.frame(asked.topic).status == TopicStatus::suspended;
  const auto& frame = context_.frame(asked.topic);
  return context_.order.current() == asked.topic &&
         frame.status == TopicStatus::active &&
         frame.slots[asked.slot].status != SlotStatus::filled;
}

const Asked* TopicEngine::latest_confirm() const {
  const auto found =
      std::find_if(confirms_.rbegin(), confirms_.rend(),
                   [](const Asked& confirm) { return !confirm.anew; });
  return found == confirms_.rend() ? nullptr : &*found;
}

bool TopicEngine::wants_a_yes(TopicId topic) const {
  return std::ranges::any_of(
      confirms_, [&](const Asked& confirm) { return confirm.topic == topic; });
}

// What would come of the topic comes when it has been answered: the question
// is made anew, as there may be other values now.
bool TopicEngine::confirms_first(const Step& step) {
  bool any = false;
  for (auto& confirm : confirms_) {
    if (confirm.topic != step.topic)
      continue;
    any = true;
    auto later = make_step(StepKind::settle, Step(step));
    later.mark = 1; // what was refused has been told, and is asked about
    context_.lane.follow(confirm.wait, std::move(later));
    if (!std::exchange(confirm.anew, true)) {
      forget_question(confirm);
      waits_.resume(confirm.wait, Value());
    }
  }
  return any;
}

void TopicEngine::forget_question(const Asked& confirm) {
  if (!asked_ || asked_->wait != confirm.wait || confirm.wait == 0)
    return;
  output_.withdraw_questions();
  asked_.reset();
}

// -- ending without an answer -------------------------------------------------

StepList TopicEngine::end_confirms(const ConfirmPredicate& wanted) {
  StepList steps;
  for (const auto& confirm : std::exchange(confirms_, {})) {
    if (!wanted(confirm)) {
      confirms_.push_back(confirm);
      continue;
    }
    forget_question(confirm);
    runner_.redirect(confirm.body);
    auto rest = context_.lane.take_out(confirm.wait);
    rest.take_if([&](const Step& step) {
      return step.kind == StepKind::conclude ||
             (step.topic == confirm.topic && concludes(step.kind));
    });
    steps.push_back(outcome_step(
        confirm.wait, fail(ErrorKind::cancelled, "it is asked no more")));
    steps.append(std::move(rest));
  }
  return steps;
}

StepList TopicEngine::end_confirms_of(TopicId topic) {
  return end_confirms(
      [&](const Asked& confirm) { return confirm.topic == topic; });
}

void TopicEngine::slot_changed(TopicId topic) {
  if (!wants_a_yes(topic))
    return;
  for (auto& step : overtaken_by_filling(topic))
    runner_.later(std::move(step));
  runner_.later(topic_step(StepKind::settle, topic));
}

// A body of a topic that begins again is what counts.
StepList TopicEngine::overtaken_by(const Step& step) {
  if (step.topic == script::no_id || confirms_.empty())
    return {};
  return end_confirms([&](const Asked& confirm) {
    return confirm.topic == step.topic && confirm.body == step.code;
  });
}

// What was asked about the topic as it was; and values that wait for an
// answer, which were said before.
StepList TopicEngine::overtaken_by_filling(TopicId id) {
  if (confirms_.empty())
    return {};
  const auto& topic = context_.topic(id);
  auto steps = end_confirms([&](const Asked& confirm) {
    return confirm.topic == id &&
           (confirm.body == topic.filled || topic.has_rule(confirm.body));
  });
  steps.append(context_.lane.take_waiting([&](const Step& step) {
    return step.kind == StepKind::fill && step.topic == id;
  }));
  return steps;
}

// What waits so is being ended by others than the topic engine.
void TopicEngine::forget_confirm(WaitId wait) {
  if (asked_ && asked_->purpose == Asked::For::yes_or_no &&
      asked_->wait == wait)
    asked_.reset();
  wait_is_over(wait);
}

void TopicEngine::wait_is_over(WaitId wait) {
  std::erase_if(confirms_,
                [&](const Asked& confirm) { return confirm.wait == wait; });
}

StepList TopicEngine::cancel_waits(const std::vector<WaitId>& but) {
  const auto ends = [&](const Asked& confirm) {
    return std::ranges::find(but, confirm.wait) == but.end();
  };
  if (asked_ && asked_->purpose == Asked::For::yes_or_no && ends(*asked_))
    asked_.reset();
  std::erase_if(confirms_, ends);
  refusals_.clear();
  query_.reset();
  return waits_.cancel(but);
}

std::vector<WaitId>
TopicEngine::confirms_but_of(const std::vector<TopicId>& topics) const {
  std::vector<WaitId> waits;
  for (const auto& confirm : confirms_)
    if (confirm.topic != script::no_id &&
        std::ranges::find(topics, confirm.topic) == topics.end())
      waits.push_back(confirm.wait);
  return waits;
}

} // namespace parlour::dialogue
