// A slot with several values: those that are said are put to the ones that are
// there, changed or taken out, one after the other (engine rule 5.14).
#include <algorithm>
#include <utility>

#include "script/dialogue/frame/filling_event.hpp"

namespace parlour::dialogue {

namespace {

using Kind = FrameChange::Kind;

// The values of one slot in one event.
struct Said {
  ManyValues values;
  const FrameChange* last = nullptr;     // that was taken
  const FrameChange* rejected = nullptr; // hardly heard
  const FrameChange* refused = nullptr;
  const FrameChange* doubtful = nullptr;
  List candidates; // of that
  bool removed = false;
  bool corrected = false;
  bool certain = true;
  Value confidence{1}; // the least

  // The list is as certain as its least certain value, since it is grounded as
  // one.
  void note(const FrameChange& change) {
    last = &change;
    certain &= !change.unmatched && is_certain_confidence(change.confidence);
    if (change.confidence.is_unknown() || confidence.is_unknown())
      confidence = {};
    else if (change.confidence.number_or(0) < confidence.number_or(0))
      confidence = change.confidence;
  }

  // A correction of what is not there takes the place of what was said last,
  // unless it goes with "not the …" or behind another one: in "no, two teas and
  // a cake", the cake replaces no tea.
  void put(const FrameChange& change, const Value& value) {
    note(change);
    const bool corrects = change.kind == Kind::correct;
    if (corrects && !corrected && !values.has(value) && !removed)
      values.replace_last(value, change.amount);
    else
      values.put(value, change.amount, change.more && !corrects);
    corrected |= corrects;
  }

  // Of what may be meant, that which is there.
  void take_out(const FrameChange& change, const Matched& matched) {
    auto value = matched.value;
    for (const auto& candidate : matched.candidates)
      if (values.has(candidate)) {
        if (!value.is_unknown())
          return;
        value = candidate;
      }
    if (!values.remove(value, change.amount))
      return;
    removed = true;
    last = &change;
  }
};

} // namespace

// The list as it was accepted, or as it waits for a yes, is changed by each
// value in turn; the result is one value of the slot, which is reported and
// grounded like any other. One outcome is reported although the values may
// differ in theirs: a doubtful one comes before a refused one, and that before
// one that was hardly heard.
void FillingEvent::fill_many(const Offer& offer) {
  const auto& definition = topic_.slots[offer.slot];
  const auto& slot = frame_.slots[offer.slot];
  const bool waits = slot.status == SlotStatus::unconfirmed;
  Said said;
  if (waits) { // in doubt with what comes to it
    said.certain = slot.certain;
    said.confidence = slot.confidence;
  }
  said.values = ManyValues(waits ? slot.value : accepted_value(slot));
  for (const auto* change : offer.items) {
    const bool denies = change->kind == Kind::deny;
    if (!denies &&
        ground(definition.confirm, change->confidence) == Grounding::reject) {
      said.rejected = change;
      continue;
    }
    auto matched = slot.status == SlotStatus::ambiguous
                       ? match_choice(definition, *change, slot.candidates,
                                      cardinalities())
                       : match(definition, *change, cardinalities());
    if (denies) {
      said.take_out(*change, matched);
    } else if (!matched.value.is_unknown()) {
      said.put(*change, matched.value);
    } else if (matched.candidates.empty()) {
      said.refused = change;
    } else {
      said.doubtful = change;
      said.candidates = std::move(matched.candidates);
    }
  }
  if (said.last)
    hold(offer.slot, *said.last, said.values.take(), said.confidence,
         said.certain);
  if (said.doubtful)
    put_candidates(offer.slot, *said.doubtful, std::move(said.candidates));
  else if (said.refused)
    refuse_item(offer.slot, *said.refused);
  else if (said.rejected && !said.last)
    report(offer.slot, SlotOutcome::rejected).offered =
        dialogue::said(*said.rejected);
}

void FillingEvent::hold(SlotId id, const FrameChange& change, Value values,
                        const Value& confidence, bool certain) {
  if (values.is_unknown()) { // the last one was taken out
    report(id, SlotOutcome::cleared);
    empty_slot(frame_.slots[id]);
    return;
  }
  put_value(id, change, values);
  auto& slot = frame_.slots[id];
  slot.confidence = confidence;
  slot.certain = certain;
  slot.wants_more = false;
}

// What else was said stays.
void FillingEvent::refuse_item(SlotId id, const FrameChange& change) {
  auto& slot = frame_.slots[id];
  if (slot.status == SlotStatus::filled && !slot.by_default)
    accept_value(slot, slot.value);
  else
    empty_slot(slot);
  report(id, SlotOutcome::refused).offered = said(change);
}

} // namespace parlour::dialogue
