#include "script/dialogue/topic_engine/filling.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/frame/grounding.hpp"
#include "script/dialogue/topic_engine/said_beside.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

namespace {

// What cannot be taken back may follow from it.
bool is_certain_and_complete(const Act& act) {
  const bool asks_anew =
      act.kind == ActKind::inform || act.kind == ActKind::request;
  return asks_anew && is_certain_confidence(act.confidence) &&
         !act.elliptical && act.alternatives.empty();
}

} // namespace

void Filling::take(steps::Fill&& step) {
  if (auto before = confirmations_.overtaken_by_filling(step.topic);
      !before.empty()) {
    before.add(std::move(step));
    context_.lane.now(std::move(before));
    return;
  }
  next_question_.speaks_of(step.topic, step.turn);
  note_changes(step, changes_);
  request(std::move(step), changes_);
  changes_.clear();
}

// Private values are noted first, before anybody can be shown what the slot has
// become.
void Filling::request(steps::Fill&& step, std::vector<FrameChange>& changes) {
  context_.conceal(step.topic, changes);
  if (!context_.port.applies_changes()) {
    tell_filled(step, frames_.apply(step.topic, changes));
    return;
  }
  auto request = std::make_shared<const FrameRequest>(
      frames_.request(step.topic, std::move(changes)));
  awaiting_ = Awaited{std::move(step), std::move(request)};
  resume();
}

void Filling::resume() const {
  if (awaiting_)
    context_.port.apply(awaiting_->step.topic, awaiting_->request);
}

void Filling::frame_applied(FrameResult result) {
  frames_.store(result.frame);
  auto step = std::move(awaiting_->step);
  awaiting_.reset();
  tell_filled(step, std::move(result));
}

// Everything about the event is said in changes, since the actor sees nothing
// of the session. The changes about the whole frame come first: an enquiry must
// forget before it is filled, and whether the act is certain must be known when
// its values are judged. A slot name that the topic does not have is skipped;
// an act that names its topic was checked before, one without a topic may have
// slots of others.
void Filling::note_changes(const steps::Fill& step,
                           std::vector<FrameChange>& changes) const {
  const auto& topic = context_.topic(step.topic);
  if (topic.kind == script::TopicKind::enquiry)
    changes.push_back(inherit(step));
  if (topic.summary == script::Summary::unless_certain)
    changes.push_back({.kind = FrameChange::Kind::said,
                       .value = is_certain_and_complete(*step.act) &&
                                !has_wish(context_.lane.ahead())});
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
    change.amount = value.amount;
    change.more = value.more;
    change.heard = value.heard;
  }
}

// What an enquiry keeps of its last answer: an elliptical turn all but what
// that answer relaxed, a full request nothing (engine rule 6).
FrameChange Filling::inherit(const steps::Fill& step) const {
  FrameChange change;
  change.kind = FrameChange::Kind::inherit;
  const auto& frame = frames_[step.topic];
  const auto& slots = context_.topic(step.topic).slots;
  const bool resting = frames_.resting() == step.topic;
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

// The result is shared from here on: each report is a step of its own.
void Filling::tell_filled(steps::Fill& step, FrameResult result) {
  for (const auto& error : result.errors) // of what the slots compute
    messenger_.script_failed(error, step.turn);
  whereabouts_.note_what_was_said(step, result);
  outcome_.filled(step, make_short_lived<const FrameResult>(std::move(result)));
}

} // namespace parlour::dialogue
