#include "script/dialogue/topic_engine/filling_outcome.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/questions/bodies.hpp"

namespace parlour::dialogue {

namespace {

// A constraint that refuses several slots says so once: "The end is before the
// beginning." is the reason of both. Equal reasons are taken for the same
// constraint. Without a reason, the cardinality refused it, which is said for
// each slot.
bool told_before(const SlotReports& reports, const SlotReport& report) {
  if (report.reason.empty())
    return false;
  const auto first = std::find_if(
      reports.begin(), reports.end(), [&](const SlotReport& other) {
        return other.outcome == SlotOutcome::refused &&
               other.reason == report.reason;
      });
  return first != reports.end() && first->slot != report.slot;
}

// Whether anything is done about what became of the slot. Where not, no step is
// made for it.
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

// A denial that emptied a slot may also be the no to a <confirm> of that slot's
// <filled>: "Really the blue one?" "Not the blue one." That is heeded here, as
// a cleared slot has no report step. Where nothing leads on, the topic settles
// at once.
void FillingOutcome::filled(const steps::Fill& step, ResultPointer result) {
  const auto& topic = context_.topic(step.topic);
  const auto& reports = result->reports;
  StepList steps;
  for (std::uint32_t i = 0; i < topic.rules.size(); ++i)
    steps.add(steps::Rule{step.topic, step.turn, i});
  if (step.act && step.act->kind == ActKind::deny)
    for (const auto& report : reports)
      if (report.outcome == SlotOutcome::cleared)
        confirm_answers_.heed_denial(step.topic, report.slot);
  for (std::uint32_t i = 0; i < reports.size(); ++i) {
    frames_.inspect_report(step.topic, reports[i]);
    if (leads_on(topic.slots[reports[i].slot], reports[i].outcome))
      steps.add(steps::Report{step.topic, step.turn, result, i});
  }
  steps::Settle settle{step.topic, step.turn, std::move(result)};
  if (steps.empty()) {
    settling_.take(std::move(settle));
    return;
  }
  steps.add(std::move(settle));
  context_.lane.now(std::move(steps));
}

void FillingOutcome::take(const steps::Rule& step) {
  const auto& rule = context_.topic(step.topic).rules[step.index];
  StepList steps;
  if (texts_.holds(rule.condition, {}, step.topic, step.turn))
    run_body(rule.body, step.topic, script::no_id, step.turn, steps);
  context_.lane.now(std::move(steps));
}

// A slot's <ambiguous> words the question itself, so what it says is noted as
// the question that waits, with the candidates as answers. A refusal counts
// even where <invalid> runs: the ladder is about answers, whoever words them.
void FillingOutcome::take(const steps::Report& step) {
  const auto& report = step.result->reports[step.index];
  const auto& slot = context_.topic(step.topic).slots[report.slot];
  StepList steps;
  switch (report.outcome) {
  case SlotOutcome::accepted:
  case SlotOutcome::corrected:
    run_body(slot.filled, step.topic, report.slot, step.turn, steps);
    break;
  case SlotOutcome::refused:
    if (slot.invalid != script::no_code)
      run_body(slot.invalid, step.topic, report.slot, step.turn, steps);
    else if (!told_before(step.result->reports, report))
      words_.say("invalid", step.topic, report.slot,
                 refusal(step.topic, report), step.turn);
    reprompts_.count_refusal(step.topic, report.slot);
    break;
  case SlotOutcome::ambiguous:
    if (slot.ambiguous != script::no_code) {
      run_body(slot.ambiguous, step.topic, report.slot, step.turn, steps);
      question_.set(
          asked_by_others(Asked::For::choice, step.topic, report.slot));
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

// What was wrong, and what would be right.
Value FillingOutcome::refusal(TopicId topic, const SlotReport& report) {
  Map refused{
      {"value", report.offered},
      {"reason", report.reason},
      {"type", context_.topic(topic).slots[report.slot].cardinality.type}};
  const auto choices = texts_.choices_of(topic, report.slot);
  for (const auto& [name, value] : choices.if_map()->entries())
    refused.set(name, value);
  return refused;
}

} // namespace parlour::dialogue
