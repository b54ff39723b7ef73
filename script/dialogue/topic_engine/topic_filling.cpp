// The part of the topic engine for a filling event (engine rule 5): an act's
// slots go to the frame's actor; what became of them leads to rules and to the
// slots' own actions.
#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

namespace {

// A constraint that refuses several slots says so once.
bool told_before(const Step& step, const SlotReport& report) {
  if (report.reason.empty())
    return false;
  const auto& reports = step.result->reports;
  const auto first = std::find_if(
      reports.begin(), reports.end(), [&](const SlotReport& other) {
        return other.outcome == SlotOutcome::refused &&
               other.reason == report.reason;
      });
  return first != reports.end() && first->slot != report.slot;
}

bool is_said(SlotOutcome outcome) {
  return outcome != SlotOutcome::cleared && outcome != SlotOutcome::rejected;
}

// What will be asked for again.
bool is_doubtful(SlotOutcome outcome) {
  return outcome == SlotOutcome::refused ||
         outcome == SlotOutcome::unconfirmed ||
         outcome == SlotOutcome::ambiguous;
}

// Whether anything is done about what became of the slot.
bool leads_on(const script::Slot& slot, SlotOutcome outcome) {
  switch (outcome) {
  case SlotOutcome::accepted:
  case SlotOutcome::corrected:
    return slot.filled != script::no_code;
  case SlotOutcome::refused:
    return true;
  case SlotOutcome::ambiguous:
    return slot.ambiguous != script::no_code;
  default:
    return false;
  }
}

} // namespace

// Also where others have said something since: of a topic that was begun, the
// slot that it would ask for now.
SlotId TopicEngine::slot_asked_for(TopicId topic) const {
  if (asked_ && asked_->topic == topic)
    return asked_->slot;
  const auto status = context_.frame(topic).status;
  if (status != TopicStatus::active && status != TopicStatus::suspended)
    return script::no_id;
  const auto slot = doubtful(topic);
  return slot == script::no_id ? missing(topic) : slot;
}

// A topic of system initiative takes only the slot asked for (engine rule 5),
// and mends of what it has; who says more is told.
void TopicEngine::keep_what_is_asked(Step& step) {
  const auto& topic = context_.topic(step.topic);
  if (topic.initiative != script::Initiative::system)
    return;
  const auto asked = slot_asked_for(step.topic);
  const auto& slots = context_.frame(step.topic).slots;
  const bool mends = step.act->kind == ActKind::correct ||
                     step.act->kind == ActKind::deny ||
                     wants_a_yes(step.topic); // "yes, but at three"
  auto act = *step.act;
  const auto dropped = std::erase_if(act.slots, [&](const SlotValue& value) {
    const auto slot = topic.slot(value.slot);
    return slot != asked && !(mends && slot != script::no_id &&
                              slots[slot].status != SlotStatus::empty);
  });
  if (dropped > 0)
    say("one_by_one", step.topic, script::no_id, {}, step.turn);
  step.act = std::make_shared<const Act>(std::move(act));
}

void TopicEngine::fill(Step& step) {
  if (auto before = overtaken_by_filling(step.topic); !before.empty()) {
    before.push_back(make_step(StepKind::fill, std::move(step)));
    context_.lane.now(std::move(before));
    return;
  }
  spoken_of_ = {step.topic, step.turn};
  note_changes(step, changes_);
  request(std::move(step), changes_);
  changes_.clear();
}

void TopicEngine::request(Step&& step, std::vector<FrameChange>& changes) {
  context_.conceal(step.topic, changes);
  if (!context_.port.writes_frames()) {
    tell_filled(step, context_.frames.apply(step.topic, changes, context_.now));
    return;
  }
  auto request =
      context_.frames.request(step.topic, std::move(changes), context_.now);
  auto topic = step.topic;
  awaiting_ = std::move(step);
  context_.port.apply(topic, std::move(request));
}

void TopicEngine::note_changes(const Step& step,
                               std::vector<FrameChange>& changes) const {
  const auto& topic = context_.topic(step.topic);
  if (topic.kind == script::TopicKind::enquiry)
    changes.push_back(inherit(step));
  for (const auto& value : step.act->slots) {
    const auto slot = topic.slot(value.slot);
    if (slot == script::no_id)
      continue;
    auto& change = changes.emplace_back();
    change.slot = slot;
    using Kind = FrameChange::Kind;
    change.kind = step.act->kind == ActKind::correct ? Kind::correct
                  : step.act->kind == ActKind::deny  ? Kind::deny
                                                     : Kind::fill;
    change.value = value.value;
    change.confidence = value.confidence;
    change.text = value.text;
    change.candidates = value.candidates;
    change.unmatched = value.unmatched;
  }
}

// What an enquiry keeps of its last answer: an elliptical turn all but what
// that answer relaxed, a full request nothing (engine rule 6).
FrameChange TopicEngine::inherit(const Step& step) const {
  FrameChange change;
  change.kind = FrameChange::Kind::inherit;
  const auto& frame = context_.frame(step.topic);
  const auto& slots = context_.topic(step.topic).slots;
  const bool resting =
      context_.order.resting(context_.now,
                             context_.program->settings.sessions.context_for) ==
      step.topic;
  const bool keeps =
      frame.status == TopicStatus::active ||
      frame.status == TopicStatus::suspended || // by a topic that it needs
      (resting && step.act->elliptical);
  for (SlotId slot = 0; keeps && slot < slots.size(); ++slot)
    if (std::find(frame.relaxed.begin(), frame.relaxed.end(),
                  slots[slot].name) == frame.relaxed.end())
      change.keep.push_back(slot);
  return change;
}

void TopicEngine::frame_applied(FrameResult result) {
  context_.frames.store(result.frame);
  auto step = std::move(*awaiting_);
  awaiting_.reset();
  tell_filled(step, std::move(result));
}

void TopicEngine::tell_filled(Step& step, FrameResult result) {
  for (const auto& error : result.errors) // of constraints
    context_.script_failed(error, step.turn);
  step.result = make_short_lived<const FrameResult>(std::move(result));
  note_what_was_said(step);
  filled(step);
}

void TopicEngine::note_what_was_said(const Step& step) {
  if (!step.act) // a yes or no
    return;
  if (std::exchange(said_.topic, step.topic) != step.topic)
    said_.slots.clear();
  for (const bool doubtful : {false, true})
    for (const auto& report : step.result->reports)
      if (is_said(report.outcome) && is_doubtful(report.outcome) == doubtful) {
        std::erase(said_.slots, report.slot);
        said_.slots.push_back(report.slot);
      }
}

void TopicEngine::filled(Step& step) {
  const auto& topic = context_.topic(step.topic);
  const auto& reports = step.result->reports;
  StepList steps;
  for (std::uint32_t i = 0; i < topic.rules.size(); ++i) {
    auto check = light_step(StepKind::rule, step);
    check.index = i;
    steps.push_back(std::move(check));
  }
  if (step.act && step.act->kind == ActKind::deny)
    for (const auto& report : reports)
      if (report.outcome == SlotOutcome::cleared)
        heed_denial(step.topic, report.slot);
  for (std::uint32_t i = 0; i < reports.size(); ++i) {
    inspect_report(step.topic, reports[i]);
    if (!leads_on(topic.slots[reports[i].slot], reports[i].outcome))
      continue;
    auto next = light_step(StepKind::report, step);
    next.result = step.result;
    next.index = i;
    next.slot = reports[i].slot;
    steps.push_back(std::move(next));
  }
  if (steps.empty()) {
    settle(step);
    return;
  }
  steps.push_back(make_step(StepKind::settle, std::move(step)));
  context_.lane.now(std::move(steps));
}

void TopicEngine::inspect_report(TopicId topic, const SlotReport& report) {
  if (!context_.port.inspected())
    return;
  const auto& slot = context_.topic(topic).slots[report.slot];
  auto value = slot.is_private
                   ? std::string("***")
                   : to_string(context_.frame(topic).slots[report.slot].value);
  context_.inspect(InspectionKind::slot,
                   context_.topic(topic).name + "." + slot.name,
                   value + " (" + std::string(name_of(report.outcome)) + ")");
}

// What was wrong, and what would be right.
Value TopicEngine::refusal(TopicId topic, const SlotReport& report) {
  Map refused{
      {"value", report.offered},
      {"reason", report.reason},
      {"type", context_.topic(topic).slots[report.slot].cardinality.type}};
  const auto choices = choices_of(topic, report.slot);
  for (const auto& [name, value] : choices.if_map()->entries())
    refused.set(name, value);
  return refused;
}

void TopicEngine::rule(Step& step) {
  const auto& rule = context_.topic(step.topic).rules[step.index];
  auto holds = runner_.evaluate(rule.condition, {}, step.topic);
  if (!holds) {
    context_.script_failed(holds.error(), step.turn);
    return;
  }
  StepList steps;
  if (*holds)
    run_body(rule.body, step.topic, script::no_id, step.turn, steps);
  context_.lane.now(std::move(steps));
}

void TopicEngine::report(Step& step) {
  const auto& slot = context_.topic(step.topic).slots[step.slot];
  const auto& report = step.result->reports[step.index];
  StepList steps;
  switch (report.outcome) {
  case SlotOutcome::accepted:
  case SlotOutcome::corrected:
    run_body(slot.filled, step.topic, step.slot, step.turn, steps);
    break;
  case SlotOutcome::refused:
    if (slot.invalid != script::no_code)
      run_body(slot.invalid, step.topic, step.slot, step.turn, steps);
    else if (!told_before(step, report))
      say("invalid", step.topic, step.slot, refusal(step.topic, report),
          step.turn);
    count_refusal(step.topic, step.slot);
    break;
  case SlotOutcome::ambiguous:
    if (slot.ambiguous != script::no_code) {
      run_body(slot.ambiguous, step.topic, step.slot, step.turn, steps);
      ask_choice(step.topic, step.slot, step.turn, false);
    }
    break;
  case SlotOutcome::unconfirmed: // asked when all else is done
  case SlotOutcome::rejected:
  case SlotOutcome::cleared:
  case SlotOutcome::unchanged:
    break;
  }
  context_.lane.now(std::move(steps));
}

} // namespace parlour::dialogue
