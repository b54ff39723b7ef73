#include "script/dialogue/frame/filling_event.hpp"

#include <algorithm>
#include <utility>

#include "runtime/text/shifted_time.hpp"
#include "script/dialogue/frame/grounding.hpp"
#include "script/dialogue/frame/matching.hpp"

namespace parlour::dialogue {

namespace {

using Kind = FrameChange::Kind;

// A refused value leaves the old one; but who says a day, though a wrong one,
// does not mean the day that was taken by default.
void drop_default(SlotState& slot) {
  if (slot.by_default)
    empty_slot(slot);
}

template <class T>
bool has(const std::vector<T>& all, const T& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

} // namespace

// A slot in doubt has its accepted value in `previous`.
const Value& accepted_value(const SlotState& slot) {
  if (slot.status == SlotStatus::filled && !slot.by_default)
    return slot.value;
  return slot.previous;
}

// `value` may be the slot's own `previous` (take_back), so it comes as a copy.
void accept_value(SlotState& slot, Value value) {
  slot.value = std::move(value);
  slot.status = SlotStatus::filled;
  slot.candidates.clear();
  slot.previous = {};
  slot.implicit = slot.by_default = false;
  slot.no_input = slot.no_match = 0;
}

// What was asked, offered and counted is about the slot, not about its value,
// so it stays: the next question is the next wording.
void empty_slot(SlotState& slot) {
  SlotState empty;
  empty.asked = slot.asked;
  empty.no_input = slot.no_input;
  empty.no_match = slot.no_match;
  empty.offered = slot.offered;
  empty.applies = slot.applies;
  empty.closed = slot.closed;
  slot = std::move(empty);
}

void take_back(SlotState& slot) {
  if (slot.previous.is_unknown())
    empty_slot(slot);
  else
    accept_value(slot, slot.previous);
}

SlotOutcome outcome_of_change(const Value& before, const Value& after) {
  if (before.is_unknown())
    return SlotOutcome::accepted;
  return before == after ? SlotOutcome::unchanged : SlotOutcome::corrected;
}

FillingEvent::FillingEvent(const script::Program& program, TopicFrame& frame,
                           const FrameEvaluator& evaluate)
    : program_(program), topic_(program.topics[frame.topic]), frame_(frame),
      evaluate_(evaluate) {}

FillingEvent::Offer& FillingEvent::offer(SlotId slot) {
  const auto found =
      std::find_if(offers_.begin(), offers_.end(),
                   [&](const Offer& known) { return known.slot >= slot; });
  if (found != offers_.end() && found->slot == slot)
    return *found;
  return *offers_.insert(found,
                         {.slot = slot, .before = frame_.slots[slot].value});
}

Expected<Value> FillingEvent::evaluate(CodeId code) const {
  return evaluate_(code, frame_, nullptr);
}

CardinalityEvaluator FillingEvent::cardinalities() const {
  return {[this](CodeId code) { return evaluate(code); }, &program_};
}

// (1) corrections and denials. Denials change the frame here, before any value
// is matched: "not the blue one, the red one" and the other way round come to
// the same. Of several values for a slot that takes one, the last wins, but
// none against a correction. A slot with many values needs all that was said,
// in order, and is dealt with in (2).
void FillingEvent::take(const FrameChange& change) {
  if (change.slot >= frame_.slots.size())
    return;
  auto& offer = this->offer(change.slot);
  if (topic_.slots[change.slot].many) {
    offer.items.push_back(&change);
    return;
  }
  const bool corrects = change.kind == Kind::correct;
  if (change.kind == Kind::deny) {
    deny(change);
  } else if (corrects || !offer.corrects) {
    offer.change = &change;
    offer.corrects = corrects;
  }
}

bool FillingEvent::denies(const FrameChange& denial, const Value& value) const {
  auto denied = match(topic_.slots[denial.slot], denial, cardinalities());
  return !value.is_unknown() && denied.value == value;
}

// "At three … no, not at three": the denial takes back what the same event
// says, and what the slot has. A denial of a value that is not there has no
// effect, and no report.
void FillingEvent::deny(const FrameChange& denial) {
  auto& slot = frame_.slots[denial.slot];
  auto& offer = this->offer(denial.slot);
  const auto& definition = topic_.slots[denial.slot];
  if (offer.change &&
      denies(denial, match(definition, *offer.change, cardinalities()).value)) {
    offer.change = nullptr;
    offer.corrects = false;
  }
  if (slot.status == SlotStatus::ambiguous) {
    narrow(offer, denial);
    return;
  }
  if (!denies(denial, slot.value))
    return;
  report(denial.slot, SlotOutcome::cleared);
  take_back(slot);
}

// "Do you mean A or B?" "Not A."
void FillingEvent::narrow(Offer& offer, const FrameChange& denial) {
  auto& candidates = frame_.slots[offer.slot].candidates;
  const auto meant = match_choice(topic_.slots[offer.slot], denial, candidates,
                                  cardinalities());
  if (meant.candidates.size() < candidates.size())
    std::erase_if(candidates, [&](const Value& value) {
      return meant.value == value || has(meant.candidates, value);
    });
  if (candidates.size() != 1 || offer.change)
    return;
  FrameChange left = denial;
  left.kind = Kind::fill;
  left.value = candidates.front();
  left.unmatched = false;
  left_by_no_.push_front(std::move(left));
  offer.change = &left_by_no_.front();
}

// The slots are matched in slot order, whatever the order of words, since a
// cardinality may read slots before it. The state before is kept only where a
// constraint might want it back.
SlotReports FillingEvent::run(std::vector<Error>& errors) {
  for (auto& offer : offers_) // (2)
    if (!offer.items.empty()) {
      const auto& slot = frame_.slots[offer.slot];
      if (!topic_.constraints.empty())
        offer.unfilled = std::make_unique<SlotState>(slot);
      fill_many(offer);
    } else if (offer.change) {
      const auto& slot = frame_.slots[offer.slot];
      if (slot.status == SlotStatus::unconfirmed)
        offer.doubted = slot.value;
      if (!topic_.constraints.empty())
        offer.unfilled = std::make_unique<SlotState>(slot);
      match_offer(offer.slot, *offer.change);
    }
  for (const auto& constraint : topic_.constraints) // (3)
    check(constraint, errors);
  for (auto& report : reports_) // (4)
    if (report.outcome == SlotOutcome::accepted)
      ground_value(report);
  return std::move(reports_);
}

// (2) a value, none, or several candidates. What is too uncertain to be
// believed counts as not said, before it can do harm to others in (3).
void FillingEvent::match_offer(SlotId id, const FrameChange& change) {
  const auto& definition = topic_.slots[id];
  auto& slot = frame_.slots[id];
  if (ground(definition.confirm, change.confidence) == Grounding::reject) {
    report(id, SlotOutcome::rejected).offered = said(change);
    return;
  }
  if (definition.cardinality.type == "time")
    if (const auto time = shifted_time(slot.value, change.value);
        !time.is_unknown()) {
      put_value(id, change, time);
      return;
    }
  auto matched =
      slot.status == SlotStatus::ambiguous
          ? match_choice(definition, change, slot.candidates, cardinalities())
          : match(definition, change, cardinalities());
  if (!matched) {
    report(id, SlotOutcome::refused).offered = said(change);
    drop_default(slot);
  } else if (matched.candidates.empty()) {
    put_value(id, change, matched.value);
  } else {
    put_candidates(id, change, std::move(matched.candidates));
  }
}

// For now the value counts as accepted: constraints read it. Grounding in (4)
// has the last word, and `previous` is what a no goes back to.
void FillingEvent::put_value(SlotId id, const FrameChange& change,
                             const Value& value) {
  auto& slot = frame_.slots[id];
  slot.previous = accepted_value(slot);
  slot.value = value;
  slot.status = SlotStatus::filled;
  slot.confidence = change.confidence;
  slot.text = change.text;
  slot.candidates.clear();
  slot.by_default = false;
  slot.certain = !change.unmatched && is_certain_confidence(change.confidence);
  report(id, SlotOutcome::accepted).offered = value;
}

void FillingEvent::put_candidates(SlotId id, const FrameChange& change,
                                  List candidates) {
  auto& slot = frame_.slots[id];
  slot.previous = accepted_value(slot);
  slot.value = {};
  slot.status = SlotStatus::ambiguous;
  slot.confidence = change.confidence;
  slot.text = change.text;
  slot.candidates = std::move(candidates);
  slot.implicit = slot.by_default = false;
  report(id, SlotOutcome::ambiguous).offered = said(change);
}

// (3) A failing constraint refuses what this event filled. Which slots it reads
// is only known when it has run. One that ends with an error counts as failing,
// without a message: a value must not pass because its check is broken.
void FillingEvent::check(const script::Constraint& constraint,
                         std::vector<Error>& errors) {
  std::vector<SlotId> reads;
  auto holds = evaluate_(constraint.condition, frame_, &reads);
  if ((holds && *holds) || !judged(reads))
    return;
  if (!holds) {
    errors.push_back(holds.error());
    refuse(reads, {});
    return;
  }
  Expected<Value> reason = Value();
  if (constraint.message != script::no_code)
    reason = evaluate(constraint.message);
  if (!reason)
    errors.push_back(reason.error());
  refuse(reads,
         reason && !reason->is_unknown() ? reason->text() : std::string());
}

bool FillingEvent::judged(const std::vector<SlotId>& reads) const {
  const auto& slots = frame_.slots;
  return std::all_of(reads.begin(), reads.end(), [&](SlotId slot) {
    return slot >= slots.size() || !slots[slot].value.is_unknown();
  });
}

void FillingEvent::refuse(const std::vector<SlotId>& reads,
                          const std::string& reason) {
  for (auto& report : reports_) {
    if (report.outcome != SlotOutcome::accepted ||
        (!reads.empty() && !has(reads, report.slot)))
      continue;
    report.outcome = SlotOutcome::refused;
    report.reason = reason;
    frame_.slots[report.slot] = *offer(report.slot).unfilled;
    drop_default(frame_.slots[report.slot]);
  }
}

// (4) To say a value again is to confirm it, whether it was accepted before or
// waits for a yes. What only sounds like it may be another name again.
void FillingEvent::ground_value(SlotReport& report) {
  auto& slot = frame_.slots[report.slot];
  report.outcome = outcome_of_change(slot.previous, slot.value);
  // To say it again is to say yes.
  const auto& offered = offer(report.slot);
  const bool known = report.outcome == SlotOutcome::unchanged ||
                     (offered.doubted == slot.value &&
                      !(offered.change && offered.change->heard));
  const auto grounding = this->grounding(report.slot);
  if (grounding == Grounding::explicitly && !known) {
    slot.status = SlotStatus::unconfirmed;
    slot.implicit = false;
    report.outcome = SlotOutcome::unconfirmed;
    return;
  }
  accept_value(slot, std::move(slot.value));
  slot.implicit = grounding == Grounding::implicitly && !known;
}

// What cannot be taken back is confirmed unless it is certain. What a summary
// confirms is not confirmed before as well, but for what must be.
Grounding FillingEvent::grounding(SlotId id) const {
  const auto& definition = topic_.slots[id];
  const auto grounding =
      ground(definition.confirm, frame_.slots[id].confidence);
  if (definition.commits && !frame_.slots[id].certain)
    return Grounding::explicitly;
  const bool summarised =
      topic_.summary != script::Summary::never &&
      definition.confirm == script::ConfirmPolicy::automatic;
  return summarised && grounding == Grounding::explicitly
             ? Grounding::implicitly
             : grounding;
}

SlotReport& FillingEvent::report(SlotId slot, SlotOutcome outcome) {
  const auto found =
      std::find_if(reports_.begin(), reports_.end(),
                   [&](const SlotReport& known) { return known.slot == slot; });
  auto& report = found == reports_.end() ? reports_.emplace_back() : *found;
  report.slot = slot;
  report.outcome = outcome;
  report.before = offer(slot).before;
  return report;
}

} // namespace parlour::dialogue
