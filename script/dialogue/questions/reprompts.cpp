#include "script/dialogue/questions/reprompts.hpp"

#include <string_view>
#include <utility>

#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/questions/bodies.hpp"
#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

namespace {

// What a <repair> is for; also the names of the events that Dialogue raises.
constexpr std::string_view not_matched = "no_match";

constexpr std::string_view not_said = "no_input";

} // namespace

// Of what is said in one breath the last counts: that is what is dealt with.
// "Uhm … a taxi" would be answered by an apology otherwise, and then by the
// taxi.
void Reprompts::misunderstood(TurnId turn, std::string heard, bool apologised) {
  if (context_.turns.said_since(turn, context_.now))
    return;
  const auto number = offers_.next_offer();
  offers_.offer("no_match", std::move(heard), number,
                steps::NotUnderstood{turn, apologised, number});
}

// A question that was withdrawn, or still waits for its release, was not
// answered badly: it only counts if it was heard.
void Reprompts::take(const steps::NotUnderstood& step) {
  if (offers_.was_consumed(step.offer))
    return;
  if (question_ && question_->heard) {
    reprompt(step.turn, true);
    return;
  }
  repairs_.missed();
  if (!step.apologised && words_.may_apologise() &&
      !repairs_.repair({.act = "no_match", .turn = step.turn}))
    words_.say("no_match", script::no_id, script::no_id, {}, step.turn);
}

void Reprompts::take(const steps::NoInput& step) {
  if (!offers_.was_consumed(step.offer) && question_ && question_->heard)
    reprompt(0, false);
}

void Reprompts::take(const steps::Ask& step) {
  if (step.slot == script::no_id) {
    Asked asked;
    asked.topic = step.topic;
    asking_.ask_change(std::move(asked), step.as, step.turn);
    return;
  }
  ask_slot(step.topic, step.slot, step.as, step.turn);
}

// The step of the ladder may have led elsewhere: by <clear>, <ask>, <transit>
// or <end/>, or to another topic. Then this question has had its time.
void Reprompts::take(const steps::AskStill& step) {
  if (!running_.redirected(step.rung) && !context_.ending.is_wished() &&
      frames_[step.topic].status == TopicStatus::active &&
      frames_.order().current() == step.topic)
    ask_slot(step.topic, step.slot, OutputAct::reprompt, step.turn);
}

void Reprompts::take(const steps::AskAgain& step) {
  if (!question_)
    return;
  if (step.same_words || !question_->asks_for_value())
    repeat_question(step.turn);
  else
    ask_slot(question_->topic, question_->slot, OutputAct::reprompt, step.turn);
}

// What is in doubt is asked for in any case.
void Reprompts::ask_slot(TopicId topic, SlotId slot, OutputAct as,
                         TurnId turn) {
  const auto status = frames_[topic].slots[slot].status;
  const bool doubtful =
      status == SlotStatus::unconfirmed || status == SlotStatus::ambiguous;
  if (doubtful || !climb_after_refusal(topic, slot, turn))
    asking_.ask_slot(topic, slot, as, turn);
}

// The question keeps what it is about, above all the wait of its script, and
// only its words are made anew. How often the slot was asked for chooses the
// wording, so that count is set back for this once; `repeats` says later that
// the release is no further question either.
void Reprompts::repeat_question(TurnId turn) {
  auto asked = *question_;
  asked.interrupted = false;
  if (asked.purpose == Asked::For::yes_or_no) {
    if (asked.summary) {
      asking_.ask_summary(std::move(asked), OutputAct::reprompt, turn);
      return;
    }
    auto text = asked.question;
    asking_.put(std::move(asked), "confirm", {}, std::move(text),
                OutputAct::reprompt, turn);
    return;
  }
  if (asked.purpose == Asked::For::which_topic) {
    clarification_.ask_which_again(std::move(asked), OutputAct::reprompt, turn);
    return;
  }
  if (asked.purpose == Asked::For::resume) {
    asking_.put(std::move(asked), "resume", {}, {}, OutputAct::reprompt, turn);
    return;
  }
  if (asked.purpose == Asked::For::change) {
    asking_.ask_change(std::move(asked), OutputAct::reprompt, turn);
    return;
  }
  if (asked.slot != script::no_id && asked.asks_for_value()) {
    auto state = frames_[asked.topic].slots[asked.slot];
    asked.repeats = true;
    state.asked = state.asked > 0 ? state.asked - 1 : 0; // the same wording
    auto code =
        question_wording(context_.topic(asked.topic).slots[asked.slot], state);
    const auto topic = asked.topic;
    auto data = asking_.question_data(asked);
    asking_.put(std::move(asked), "question", std::move(data),
                texts_.text_of(code, topic), OutputAct::reprompt, turn);
    return;
  }
  ask_slot(asked.topic, asked.slot, OutputAct::reprompt, turn);
}

void Reprompts::reprompt(TurnId turn, bool heard_something) {
  const auto times = count_miss(heard_something);
  climb({.act = heard_something ? not_matched : not_said,
         .topic = question_->topic,
         .slot = question_->slot,
         .count = times,
         .turn = turn});
}

// The slot's own <nomatch> or <noinput>, the settings' <ladder>, else the
// <repair> for it; the question as it was where there is none of them, or the
// robot would be silent.
void Reprompts::climb(const Trouble& trouble) {
  const bool of_slot = trouble.slot != script::no_id;
  if (of_slot && run_own_words(trouble))
    return;
  if (of_slot && !context_.program->ladder.empty())
    climb_own(trouble);
  else if (!repairs_.repair(trouble))
    repeat_question(trouble.turn);
}

std::uint32_t Reprompts::count_miss(bool heard_something) {
  if (question_->slot == script::no_id)
    return question_.count_miss();
  FrameChange count;
  count.kind = heard_something ? FrameChange::Kind::no_match
                               : FrameChange::Kind::no_input;
  count.slot = question_->slot;
  frames_.change(question_->topic, count);
  const auto& state = frames_[question_->topic].slots[question_->slot];
  return heard_something ? state.no_match : state.no_input;
}

void Reprompts::count_refusal(TopicId topic, SlotId slot) {
  if (frames_[topic].slots[slot].asked == 0)
    return; // nobody had asked
  frames_.change(topic, {.kind = FrameChange::Kind::no_match, .slot = slot});
  refused_ = SlotOf{topic, slot};
}

// The first time, what does not fit was told, and the question comes as ever.
// From the second time on the ladder is climbed, which asks by itself. The
// question is set as one that was heard, since a <repair> asks about the open
// one.
bool Reprompts::climb_after_refusal(TopicId topic, SlotId slot, TurnId turn) {
  const bool refused =
      refused_ && refused_->topic == topic && refused_->slot == slot;
  const auto times = frames_[topic].slots[slot].no_match;
  if (!refused || times < 2)
    return false;
  refused_.reset();
  question_.set(asked_by_others(Asked::For::value, topic, slot));
  climb({.act = not_matched,
         .topic = topic,
         .slot = slot,
         .count = times,
         .turn = turn,
         .refused = true});
  return true;
}

bool Reprompts::run_own_words(const Trouble& trouble) {
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
// the step has asked, cleared or left. Beyond the last step, the last one is
// taken again.
void Reprompts::climb_own(const Trouble& trouble) {
  const auto& ladder = context_.program->ladder;
  const auto last = ladder.size() - 1;
  const auto rung = trouble.count == 0 ? 0 : trouble.count - 1;
  const auto body = ladder[std::min<std::size_t>(rung, last)];
  StepList steps;
  run_body(body, trouble.topic, trouble.slot, trouble.turn, steps);
  steps.add(steps::AskStill{trouble.topic, trouble.slot, trouble.turn, body});
  context_.lane.now(std::move(steps));
}

} // namespace parlour::dialogue
