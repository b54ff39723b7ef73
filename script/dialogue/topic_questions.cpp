// The part of the topic engine that asks: for slots, for a choice, for a yes;
// again when nothing was understood or nobody answered (engine rules 3 and 5).
#include <algorithm>
#include <utility>

#include "script/dialogue/core.hpp"
#include "script/dialogue/questions.hpp"
#include "script/dialogue/steps.hpp"

namespace parlour::dialogue {

// -- which question -----------------------------------------------------------

void TopicEngine::conclude(Step step) {
  if (core_.lane.returning()) // what waited for this goes on, and concludes
    return;
  if (asked_ && (asked_->heard || asked_->pending))
    return;
  Step next;
  next.turn = step.turn;
  ask_next(next);
}

void TopicEngine::ask_next(Step step) {
  auto current = core_.order.current();
  if (core_.ending || !current || waits_for_user(*current))
    return;
  if (auto slot = to_ask(*current); slot != script::no_id)
    ask_slot(*current, slot, step.output, step.turn);
}

// Whether the topic must not ask: in a subtask, or while it waits for a yes.
bool TopicEngine::waits_for_user(TopicId topic) const {
  return core_.states.pushed() ||
         std::any_of(
             confirms_.begin(), confirms_.end(),
             [&](const Asked& confirm) { return confirm.topic == topic; });
}

// What is in doubt must be settled in any case; what is missing is asked for
// where the topic asks at all.
SlotId TopicEngine::to_ask(TopicId topic) const {
  const auto& definition = core_.topic(topic);
  if (core_.frame(topic).status != TopicStatus::active)
    return script::no_id;
  if (auto slot = doubtful(topic); slot != script::no_id)
    return slot;
  return definition.kind == script::TopicKind::task &&
                 definition.initiative != script::Initiative::user
             ? missing(topic)
             : script::no_id;
}

void TopicEngine::ask(Step step) {
  if (step.slot != script::no_id)
    ask_slot(step.topic, step.slot, step.output, step.turn);
  else if (!confirms_.empty()) {
    asked_ = confirms_.back();
    repeat_question(step.turn);
  }
}

void TopicEngine::ask_slot(TopicId topic, SlotId slot, OutputAct as,
                           TurnId turn) {
  const auto& state = core_.frame(topic).slots[slot];
  if (state.status == SlotStatus::unconfirmed) {
    ask_confirmation(topic, slot, turn);
    return;
  }
  if (state.status == SlotStatus::ambiguous) {
    ask_choice(topic, slot, turn, true);
    return;
  }
  Asked asked;
  asked.topic = topic;
  asked.slot = slot;
  auto code = question_wording(core_.topic(topic).slots[slot], state);
  put(std::move(asked), "question", {}, text_of(code, topic), as, turn);
}

void TopicEngine::ask_confirmation(TopicId topic, SlotId slot, TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::confirmation;
  asked.topic = topic;
  asked.slot = slot;
  const auto& value = core_.frame(topic).slots[slot].value;
  put(std::move(asked), "confirm", Map{{"value", value}}, {},
      OutputAct::question, turn);
}

// Several candidates: the slot's <ambiguous> asks, or "Do you mean A or B?".
void TopicEngine::ask_choice(TopicId topic, SlotId slot, TurnId turn,
                             bool aloud) {
  Asked asked;
  asked.purpose = Asked::For::choice;
  asked.topic = topic;
  asked.slot = slot;
  const auto& state = core_.frame(topic).slots[slot];
  if (aloud) {
    put(std::move(asked), "ambiguous",
        Map{{"candidates", state.candidates}, {"text", state.text}}, {},
        OutputAct::question, turn);
    return;
  }
  asked.heard = true; // by the script's own words
  asked.pending = false;
  asked_ = std::move(asked);
}

void TopicEngine::confirm(std::string question, TopicId topic, WaitId wait,
                          TurnId turn) {
  Asked asked;
  asked.purpose = Asked::For::yes_or_no;
  asked.topic = topic;
  asked.wait = wait;
  asked.question = question;
  asked.pending = false;
  asked.heard = true; // as soon as it comes to that
  confirms_.push_back(asked);
  put(std::move(asked), "confirm", {}, std::move(question), OutputAct::question,
      turn);
}

void TopicEngine::put(Asked asked, const char* act, Value data,
                      std::string text, OutputAct as, TurnId turn) {
  Say what;
  what.as = as;
  what.act = act;
  what.topic = asked.topic;
  what.slot = asked.slot;
  what.data = with_marks(asked.topic, std::move(data));
  what.text = std::move(text);
  what.turn = turn;
  asked.heard = false;
  asked.pending = true;
  asked_ = std::move(asked);
  asked_->output = core_.mouth.say(std::move(what));
  if (asked_->output == 0)
    unspoken(0);
}

std::string TopicEngine::text_of(CodeId code, TopicId topic) {
  if (code == script::no_code)
    return {};
  auto text = core_.runner.evaluate(code, {}, topic);
  if (text)
    return text->text();
  core_.inspect(InspectionKind::error, core_.topic(topic).name,
                to_string(text.error()));
  return {};
}

// -- what became of it --------------------------------------------------------

void TopicEngine::released(const Output& output) {
  if (output.topic != script::no_id)
    unmark(output.topic);
  if (!asked_ || asked_->output != output.id)
    return;
  asked_->pending = false;
  asked_->heard = true;
  if (asked_->slot == script::no_id || asked_->repeats ||
      asked_->purpose != Asked::For::value)
    return;
  FrameChange count;
  count.kind = FrameChange::Kind::asked;
  count.slot = asked_->slot;
  change(asked_->topic, std::move(count));
}

// The marked values were in an output.
void TopicEngine::unmark(TopicId topic) {
  const auto& slots = core_.frame(topic).slots;
  if (std::any_of(slots.begin(), slots.end(),
                  [](const SlotState& slot) { return slot.implicit; }))
    change(topic, {.kind = FrameChange::Kind::echoed});
}

void TopicEngine::withdrawn(const Output& output) {
  if (asked_ && asked_->output == output.id)
    asked_->pending = false;
}

// A question without words counts as asked: silence after it ends somewhere.
void TopicEngine::unspoken(OutputId output) {
  if (!asked_ || !asked_->pending || asked_->output != output)
    return;
  asked_->pending = false;
  asked_->heard = true;
}

// -- when nothing comes of it -------------------------------------------------

void TopicEngine::no_match(Step step) {
  core_.turns.taken_up(step.turn);
  core_.turns.let_go(step.turn);
  no_input_ = 0;
  not_understood(step.turn, step.mark == 0);
}

void TopicEngine::not_understood(TurnId turn, bool apologise) {
  if (!asked_ || !asked_->heard) {
    if (apologise)
      say("no_match", script::no_id, script::no_id, {}, turn);
    return;
  }
  reprompt(turn, true);
}

// The slot's own <nomatch> or <noinput>, else the standard ladder.
void TopicEngine::reprompt(TurnId turn, bool heard_something) {
  if (asked_->slot == script::no_id) {
    repeat_question(turn);
    return;
  }
  const auto topic = asked_->topic;
  const auto slot = asked_->slot;
  FrameChange count;
  count.kind = heard_something ? FrameChange::Kind::no_match
                               : FrameChange::Kind::no_input;
  count.slot = slot;
  change(topic, std::move(count));
  const auto& definition = core_.topic(topic).slots[slot];
  const auto& state = core_.frame(topic).slots[slot];
  const auto times = heard_something ? state.no_match : state.no_input;
  auto body = counted_body(
      heard_something ? definition.no_match : definition.no_input, times);
  if (body == script::no_code) {
    climb(topic, slot, times, turn);
    return;
  }
  std::vector<Step> steps;
  run_body(body, topic, slot, turn, steps);
  core_.lane.now(std::move(steps));
}

// The standard ladder: repeat, rephrase, explain, offer choices, offer a
// person (engine rule 5).
void TopicEngine::climb(TopicId topic, SlotId slot, std::uint32_t times,
                        TurnId turn) {
  const auto& definition = core_.topic(topic).slots[slot];
  switch (ladder_step(definition, times)) {
  case LadderStep::repeat:
    repeat_question(turn);
    return;
  case LadderStep::rephrase:
    break;
  case LadderStep::explain:
    say_text(
        text_of(explain_wording(definition, core_.frame(topic).slots[slot]),
                topic),
        turn);
    break;
  case LadderStep::offer_choices:
    say("choices", topic, slot, choices_of(topic, slot), turn);
    break;
  case LadderStep::offer_person:
    say("person", topic, slot, {}, turn);
    return;
  }
  ask_slot(topic, slot, OutputAct::reprompt, turn);
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

void TopicEngine::repeat_question(TurnId turn) {
  auto asked = *asked_;
  if (asked.purpose == Asked::For::yes_or_no) {
    auto text = asked.question;
    put(std::move(asked), "confirm", {}, std::move(text), OutputAct::reprompt,
        turn);
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
