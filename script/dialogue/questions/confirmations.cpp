#include "script/dialogue/questions/confirmations.hpp"

#include <algorithm>
#include <concepts>
#include <memory>
#include <utility>
#include <variant>

namespace parlour::dialogue {

namespace {

template <class Kind, class... Kinds>
constexpr bool is_any_of = (std::same_as<Kind, Kinds> || ...);

// What comes of the topic when its scripts have run. A script that is ended as
// cancelled still has to clean up, but the topic must not be completed by it.
bool concludes(const Step& step, TopicId topic) {
  return std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (is_any_of<Kind, steps::Settle, steps::Finish,
                                steps::WindUp, steps::Answer>)
          return kind.topic == topic;
        else
          return false;
      },
      step);
}

} // namespace

void Confirmations::confirm(std::string question, TopicId topic, SlotId slot,
                            WaitId wait, TurnId turn) {
  auto asked = waiting(topic, wait);
  asked.about = slot;
  asked.question = question;
  note_question_before(asked, turn);
  confirms_.push_back(asked);
  asking_.put(std::move(asked), "confirm", {}, std::move(question),
              OutputAct::question, turn);
}

void Confirmations::summarise(TopicId topic, WaitId wait, TurnId turn) {
  auto asked = waiting(topic, wait);
  asked.summary = true;
  confirms_.push_back(asked);
  asking_.ask_summary(std::move(asked), OutputAct::question, turn);
}

// Heard as soon as it comes to that.
Asked Confirmations::waiting(TopicId topic, WaitId wait) const {
  Asked asked;
  asked.purpose = Asked::For::yes_or_no;
  asked.topic = topic;
  asked.wait = wait;
  asked.body = running_.body();
  asked.level = context_.states.levels().size();
  asked.pending = false;
  asked.heard = true;
  return asked;
}

// A handler asks "Did you say four?" about the answer to "For how many?". After
// the yes, "four" must be understood as that answer, so the question before is
// kept. Who asks about the same words again has not answered that either: then
// the question before the first <confirm> is meant.
void Confirmations::note_question_before(Asked& asked, TurnId turn) const {
  if (asked.topic != script::no_id || turn == 0 || !question_ ||
      !question_->heard)
    return;
  const bool again = question_->wait != 0 && question_->body == asked.body;
  asked.before =
      again ? question_->before : std::make_shared<const Asked>(*question_);
}

// A handler's, as the words that it asked about may answer that. A question for
// a value is marked as interrupted: if the words are no answer, silence brings
// it again. One of yes or no is not, as the words may be its yes.
void Confirmations::back_to_question_before(const Asked& asked) {
  if (!asked.before || context_.lane.waits(asked.wait) ||
      !may_be_answered(*asked.before))
    return;
  question_.set(*asked.before);
  if (!question_->wants_yes_or_no())
    question_.interrupt(); // it comes again
}

// A <confirm> as long as it waits; whether to resume a topic, while that is
// suspended; a slot, while its topic is the current one and the slot empty or
// in doubt.
bool Confirmations::may_be_answered(const Asked& asked) const {
  if (asked.wait != 0)
    return std::ranges::any_of(confirms_, [&](const Asked& confirm) {
      return confirm.wait == asked.wait && !confirm.anew;
    });
  if (asked.slot == script::no_id)
    return asked.topic == script::no_id ||
           frames_[asked.topic].status == TopicStatus::suspended;
  const auto& frame = frames_[asked.topic];
  return frames_.order().current() == asked.topic &&
         frame.status == TopicStatus::active &&
         frame.slots[asked.slot].status != SlotStatus::filled;
}

const Asked* Confirmations::latest_confirm() const {
  const auto found =
      std::find_if(confirms_.rbegin(), confirms_.rend(),
                   [](const Asked& confirm) { return !confirm.anew; });
  return found == confirms_.rend() ? nullptr : &*found;
}

bool Confirmations::wants_a_yes(TopicId topic) const {
  return std::ranges::any_of(
      confirms_, [&](const Asked& confirm) { return confirm.topic == topic; });
}

// What would come of the topic comes when it has been answered: the question is
// made anew, as there may be other values now. The step follows the <confirm>'s
// activation. That is woken with an unknown outcome, neither yes nor no, by
// which the compiled loop around a <confirm> asks once more; `anew` sees to it
// that this happens once.
bool Confirmations::confirms_first(const steps::Settle& step) {
  bool any = false;
  for (auto& confirm : confirms_) {
    if (confirm.topic != step.topic)
      continue;
    any = true;
    auto later = step;
    later.told = true; // what was refused, and is asked about
    context_.lane.follow(confirm.wait, std::move(later));
    if (!std::exchange(confirm.anew, true)) {
      forget_question(confirm);
      context_.lane.wake(confirm.wait, outcome_step(confirm.wait, Value()));
    }
  }
  return any;
}

void Confirmations::forget_question(const Asked& confirm) {
  if (!question_ || question_->wait != confirm.wait || confirm.wait == 0)
    return;
  asking_.withdraw();
}

// What the agenda of such a wait still had to do comes with the steps, but for
// what would complete the topic or conclude: that follows from whatever ends
// the wait. The body counts as redirected, so that a topic whose <filled> is
// cancelled does not finish by it.
StepList Confirmations::end_confirms(const ConfirmPredicate& wanted) {
  StepList steps;
  for (const auto& confirm : std::exchange(confirms_, {})) {
    if (!wanted(confirm)) {
      confirms_.push_back(confirm);
      continue;
    }
    forget_question(confirm);
    running_.redirect(confirm.body);
    auto agenda = context_.lane.take_out(confirm.wait);
    agenda.take_if([&](const Step& step) {
      return is<steps::Conclude>(step) || concludes(step, confirm.topic);
    });
    steps.add(outcome_step(confirm.wait,
                           fail(ErrorKind::cancelled, "it is asked no more")));
    steps.append(std::move(agenda));
  }
  return steps;
}

StepList Confirmations::end_confirms_of(TopicId topic) {
  return end_confirms(
      [&](const Asked& confirm) { return confirm.topic == topic; });
}

void Confirmations::slot_changed(TopicId topic) {
  if (!wants_a_yes(topic))
    return;
  for (auto& step : overtaken_by_filling(topic))
    running_.later(std::move(step));
  running_.later(steps::Settle{topic});
}

// A body of a topic that begins again is what counts.
StepList Confirmations::overtaken_by(const Body& body) {
  if (body.topic == script::no_id || confirms_.empty())
    return {};
  return end_confirms([&](const Asked& confirm) {
    return confirm.topic == body.topic && confirm.body == body.code;
  });
}

// What was asked about the topic as it was; and values that wait for an answer,
// which were said before: they are filled first, in the order in which they
// were said.
StepList Confirmations::overtaken_by_filling(TopicId id) {
  if (confirms_.empty())
    return {};
  const auto& topic = context_.topic(id);
  auto steps = end_confirms([&](const Asked& confirm) {
    return confirm.topic == id &&
           (confirm.body == topic.filled || topic.has_rule(confirm.body));
  });
  steps.append(context_.lane.take_waiting([&](const Step& step) {
    const auto* fill = std::get_if<steps::Fill>(&step);
    return fill && fill->topic == id;
  }));
  return steps;
}

// What waits so is being ended by others than the topic engine.
void Confirmations::forget_confirm(WaitId wait) {
  if (question_ && question_->purpose == Asked::For::yes_or_no &&
      question_->wait == wait)
    question_.reset();
  wait_is_over(wait);
}

void Confirmations::wait_is_over(WaitId wait) {
  std::erase_if(confirms_,
                [&](const Asked& confirm) { return confirm.wait == wait; });
}

std::vector<WaitId>
Confirmations::confirms_but_of(const std::vector<TopicId>& topics) const {
  std::vector<WaitId> waits;
  for (const auto& confirm : confirms_)
    if (confirm.topic != script::no_id &&
        std::ranges::find(topics, confirm.topic) == topics.end())
      waits.push_back(confirm.wait);
  return waits;
}

// The script's own deeds decide: as soon as <completed> has sent, spoken or set
// anything, the topic is done, whatever its later <confirm>s are answered.
bool Confirmations::is_completing(TopicId topic) const {
  const auto body = context_.topic(topic).completed;
  return frames_[topic].status == TopicStatus::completed &&
         !running_.acted(body) &&
         std::ranges::any_of(confirms_, [&](const Asked& confirm) {
           return confirm.topic == topic && confirm.body == body;
         });
}

TopicId Confirmations::completing() const {
  const auto found = std::find_if(
      confirms_.rbegin(), confirms_.rend(), [&](const Asked& confirm) {
        return confirm.topic != script::no_id && is_completing(confirm.topic);
      });
  return found == confirms_.rend() ? script::no_id : found->topic;
}

void Confirmations::prefer_named_confirm(TopicId topic) {
  if (topic == script::no_id || (question_ && question_->topic == topic))
    return;
  const auto named = std::find_if(
      confirms_.rbegin(), confirms_.rend(), [&](const Asked& confirm) {
        return confirm.topic == topic && !confirm.anew;
      });
  if (named != confirms_.rend())
    question_.set(*named);
}

void Confirmations::cancel_confirms(const std::vector<WaitId>& but) {
  const auto ends = [&](const Asked& confirm) {
    return std::ranges::find(but, confirm.wait) == but.end();
  };
  if (question_ && question_->purpose == Asked::For::yes_or_no &&
      ends(*question_))
    question_.reset();
  std::erase_if(confirms_, ends);
}

} // namespace parlour::dialogue
