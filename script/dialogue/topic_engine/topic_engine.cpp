#include "script/dialogue/topic_engine/topic_engine.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topics/misnamed.hpp"
#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

namespace {

const std::string dialogue_source = "Dialogue";

bool listens_to_silence(const script::State& state) {
  return std::any_of(state.messages.begin(), state.messages.end(),
                     [](const script::Reaction& reaction) {
                       return reaction.event == "no_input" &&
                              reaction.source == dialogue_source;
                     });
}

// Remembered, of what is never asked for again: its utterance was dropped.
constexpr std::size_t most_consumed = 1000;

// It is for what was asked, and begins no topic.
bool is_answer(const Act& act) {
  return act.slots.empty() &&
         (act.kind == ActKind::confirm || act.kind == ActKind::deny);
}

} // namespace

TopicEngine::TopicEngine(DialogueContext& context, ActivationRunner& runner,
                         Waits& waits, const Reactions& reactions,
                         OutputManager& output, PushedStates& pushed_states)
    : context_(context), runner_(runner), waits_(waits), reactions_(reactions),
      output_(output), pushed_states_(pushed_states) {
  for (const auto& state : context.program->states)
    listens_to_silence_.push_back(listens_to_silence(state));
}

void TopicEngine::take(Step&& step) {
  switch (step.kind) {
// clang-format off
#define TAKES(kind) \
  case StepKind::kind: kind(step); return;
    TAKES(take_act) TAKES(topic_act) TAKES(no_match)
    TAKES(conclude) TAKES(activate) TAKES(fill) TAKES(rule)
    TAKES(report) TAKES(settle) TAKES(finish) TAKES(complete) TAKES(wind_up)
    TAKES(reset)
    TAKES(look_up) TAKES(looked_up) TAKES(answer) TAKES(ask) TAKES(ask_next)
    TAKES(ask_still) TAKES(ask_again) TAKES(resume_topic) TAKES(cancel)
    TAKES(cancel_topic) TAKES(not_understood) TAKES(no_input)
#undef TAKES
        // clang-format on
        default : return; // another part's
  }
}

// -- an act's way (engine rule 2) ---------------------------------------------

void TopicEngine::take_act(Step& step) {
  if (joins(step))
    return;
  context_.turns.taken_up(step.turn);
  context_.turns.let_go(step.turn);
  no_input_ = 0;
  refused_.reset();
  if (context_.privacy.is_needed())
    conceal_values(*step.act);
  if (std::exchange(turn_, step.turn) != step.turn)
    said_before_ = output_.spoken();
  if (context_.states.pushed() || !answer_to_question(step))
    offer_act(step);
}

// Before anybody is told of them, whatever becomes of the act. Where it names
// no topic, they may be any one's.
void TopicEngine::conceal_values(const Act& act) {
  const auto& topics = context_.program->topics;
  for (TopicId id = 0; id < topics.size(); ++id)
    for (const auto& said : act.slots) {
      const auto slot = topics[id].slot(said.slot);
      if (slot == script::no_id ||
          !(act.topic.empty() || topics[id].name == act.topic))
        continue;
      FrameChange change;
      change.slot = slot;
      change.value = said.value;
      change.candidates = said.candidates;
      change.text = said.text;
      context_.conceal(id, {&change, 1});
    }
  for (const auto& other : act.alternatives)
    conceal_values(other);
}

void TopicEngine::offer_act(Step& step) {
  const auto command = std::string(name_of(step.act->kind));
  const auto* state = context_.active_state();
  if (reactions_.listens(dialogue_source, command)) {
    auto parameter = to_value(*step.act); // which nobody else would read
    offer(command, std::move(parameter),
          make_step(StepKind::topic_act, std::move(step)));
  } else if (state && state->capture != script::Capture::none) {
    // The state keeps every act for itself; this one it has no use for, unless
    // it is to a question of its own.
    if (!asked_here() || !answer_to_question(step))
      misunderstood(std::move(step));
  } else {
    topic_act(step);
  }
}

void TopicEngine::offer(std::string command, Value parameter, Step otherwise) {
  if (consumed_.size() > most_consumed)
    consumed_.erase(consumed_.begin());
  Message message;
  message.source = dialogue_source;
  message.command = std::move(command);
  message.params = {std::move(parameter)};
  message.time = context_.now;
  message.session = context_.options.session;
  message.number = otherwise.offered = ++offered_;
  auto shared = std::make_shared<const Message>(std::move(message));
  StepList steps;
  bool captured = false;
  for (const auto& match :
       reactions_.matches(dialogue_source, shared->command)) {
    auto reaction = body_step(match.reaction->body, otherwise.turn);
    reaction.kind = StepKind::react;
    reaction.origin.visit = match.visit;
    reaction.matter().message = shared;
    reaction.offered = otherwise.offered;
    steps.push_back(std::move(reaction));
    captured = captured || match.captures;
  }
  if (!captured)
    steps.push_back(std::move(otherwise));
  context_.lane.now(std::move(steps));
}

bool TopicEngine::was_consumed(const Step& otherwise) {
  return consumed_.erase(otherwise.offered) > 0;
}

void TopicEngine::topic_act(Step& step) {
  if (was_consumed(step))
    return;
  // Who was offered it might have known the name.
  if (const auto error = misnamed(*context_.program, *step.act)) {
    context_.script_failed(*error, step.turn);
    return;
  }
  if (answer_to_question(step) || leaves_open_which(step))
    return;
  complete_by_answer(step);
  if (step.act->elliptical && !step.act->alternatives.empty()) {
    auto act = *step.act;
    prefer_resting(*context_.program, act, classifier_context());
    step.act = std::make_shared<const Act>(std::move(act));
  }
  const auto& act = *step.act;
  step.topic = context_.program->topic(act.topic);
  if (is_generic(act) && (step.topic == script::no_id || wants_out(act))) {
    generic_act(step);
    return;
  }
  if (corrects_what_is_done(step))
    return;
  if (step.topic == script::no_id || !context_.order.registered(step.topic))
    step.topic = classify(*context_.program, act, classifier_context());
  if (is_answer(act) && !asked_) { // "ok", and nobody had asked
    misses_ = 0;
    say("acknowledge", script::no_id, script::no_id, {}, step.turn);
    return;
  }
  const bool says_nothing =
      act.topic.empty() && act.slots.empty() && !act.elliptical;
  if (step.topic == script::no_id || says_nothing || is_answer(act)) {
    misunderstood(std::move(step));
    return;
  }
  misses_ = 0;
  if (ask_which(step))
    return;
  keep_what_is_asked(step);
  StepList steps;
  begin_topic(step.topic, steps);
  if (steps.empty()) {
    fill(step);
    return;
  }
  steps.push_back(make_step(StepKind::fill, std::move(step)));
  context_.lane.now(std::move(steps));
}

bool TopicEngine::is_waited_for(const Act& act) const {
  if (passes_waits(act))
    return true;
  if (context_.states.pushed() &&
      reactions_.state_listens(dialogue_source, name_of(act.kind)))
    return true;
  return !confirms_.empty() && is_answer(act);
}

// -- small things -------------------------------------------------------------

void TopicEngine::change(TopicId topic, const FrameChange& change) {
  context_.conceal(topic, {&change, 1});
  for (const auto& report : context_.frames.change(topic, change, context_.now))
    inspect_report(topic, report);
}

void TopicEngine::reset(Step& step) {
  auto steps = end_confirms_of(step.topic);
  change(step.topic, {.kind = FrameChange::Kind::reset});
  context_.lane.now(std::move(steps));
}

void TopicEngine::set_status(TopicId topic, TopicStatus status) {
  if (context_.frame(topic).status == status)
    return;
  context_.frames.set_status(topic, status, context_.now);
  if (context_.port.inspected())
    context_.inspect(InspectionKind::topic, context_.topic(topic).name,
                     std::string(name_of(status)));
}

void TopicEngine::say(const char* act, TopicId topic, SlotId slot, Value data,
                      TurnId turn) {
  Say what;
  what.act = act;
  what.topic = topic;
  what.slot = slot;
  what.data = with_marks(topic, std::move(data));
  what.turn = turn;
  output_.say(std::move(what));
}

// Values to be echoed in what is said of their topic (grounding: implicit).
Value TopicEngine::with_marks(TopicId topic, Value data) const {
  if (topic == script::no_id)
    return data;
  const auto& slots = context_.topic(topic).slots;
  Map marked;
  for (SlotId slot = 0; slot < slots.size(); ++slot)
    if (const auto& state = context_.frame(topic).slots[slot]; state.implicit)
      marked.set(slots[slot].name, state.value);
  if (marked.empty())
    return data;
  auto map = data.if_map() ? *data.if_map() : Map();
  map.set("implicit", std::move(marked));
  return map;
}

void TopicEngine::run_body(CodeId code, TopicId topic, SlotId slot, TurnId turn,
                           StepList& steps) const {
  if (code == script::no_code)
    return;
  auto& step = steps.add(StepKind::run);
  step.code = code;
  step.topic = topic;
  step.slot = slot;
  step.turn = turn;
}

SlotId TopicEngine::missing(TopicId topic) const {
  return missing_slot(context_.topic(topic), context_.frame(topic));
}

// The first slot that waits for a yes or a choice.
SlotId TopicEngine::doubtful(TopicId topic) const {
  const auto& slots = context_.frame(topic).slots;
  for (SlotId slot = 0; slot < slots.size(); ++slot)
    if (slots[slot].status == SlotStatus::unconfirmed ||
        slots[slot].status == SlotStatus::ambiguous)
      return slot;
  return script::no_id;
}

} // namespace parlour::dialogue
