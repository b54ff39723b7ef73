// FillingEvent: what an utterance says about the slots of one frame, in the
// order of engine rule 5: corrections and denials; values matched to their
// cardinality in slot order; constraints, each once; grounding. An internal
// part of apply (topic_frame.hpp).
#pragma once

#include <forward_list>
#include <memory>
#include <vector>

#include "script/dialogue/frame/grounding.hpp"
#include "script/dialogue/frame/many_values.hpp"
#include "script/dialogue/frame/matching.hpp"
#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::dialogue {

// The slot has this value for certain; doubts and failures are forgotten.
void accept_value(SlotState& slot, Value value);

// What counts as said before: a default does not.
const Value& accepted_value(const SlotState& slot);

// The slot has no value; how often it was asked for stays.
void empty_slot(SlotState& slot);

// An unconfirmed value goes, the one accepted before it comes back; another
// value just goes, as accepting it has forgotten the one before.
void take_back(SlotState& slot);

// accepted, corrected or unchanged.
SlotOutcome outcome_of_change(const Value& before, const Value& after);

// Refers to all that it is given; lives for one event. The changes that are
// taken must outlive it. To use: take() each change in the order of the act,
// then run() once.
class FillingEvent {
public:
  FillingEvent(const script::Program& program, TopicFrame& frame,
               const FrameEvaluator& evaluate);

  // A fill, correct or deny. A correction stands against later fills; a denial
  // takes back an equal value said before it in the same event. A slot that the
  // topic does not have is ignored.
  void take(const FrameChange& change);

  // Changes the frame; one report for each slot that was spoken of with some
  // effect, in no certain order. Errors of constraints are appended.
  SlotReports run(std::vector<Error>& errors);

private:
  // What was said of a slot, and how the slot was before.
  struct Offer {
    SlotId slot;
    const FrameChange* change = nullptr;        // null: only denials
    ShortLivedList<const FrameChange*> items{}; // of a slot with many values
    bool corrects = false;
    Value before{};  // the event
    Value doubted{}; // after the denials: that waited for a yes
    // After the denials, for constraints to go back to; null: there are none.
    std::unique_ptr<SlotState> unfilled{};
  };

  Offer& offer(SlotId slot); // in slot order; made where there is none
  Expected<Value> evaluate(CodeId code) const;
  CardinalityEvaluator cardinalities() const;
  void deny(const FrameChange& change);
  // Whether the denial means this value, by the slot's cardinality.
  bool denies(const FrameChange& denial, const Value& value) const;
  // Strikes a candidate out; the last one that is left counts as said.
  void narrow(Offer& offer, const FrameChange& denial);

  // Step (2) for a slot with several values (engine rule 5.14).
  void fill_many(const Offer& offer);
  // The list is the slot's value now; unknown: it is empty.
  void hold(SlotId slot, const FrameChange& change, Value values,
            const Value& confidence, bool certain);
  void refuse_item(SlotId slot, const FrameChange& change);
  void match_offer(SlotId slot, const FrameChange& change);
  void put_value(SlotId slot, const FrameChange& change, const Value& value);
  void put_candidates(SlotId slot, const FrameChange& change, List candidates);

  void check(const script::Constraint& constraint, std::vector<Error>& errors);
  // Whether all slots that a constraint reads have values.
  bool judged(const std::vector<SlotId>& reads) const;
  // Of this event's values those that the constraint reads; all, if it reads
  // none.
  void refuse(const std::vector<SlotId>& reads, const std::string& reason);

  Grounding grounding(SlotId slot) const;
  void ground_value(SlotReport& report);
  // The slot's report, made where there is none; a later outcome takes the
  // place of an earlier one.
  SlotReport& report(SlotId slot, SlotOutcome outcome);

  const script::Program& program_;
  const script::Topic& topic_;
  TopicFrame& frame_;
  const FrameEvaluator& evaluate_;
  ShortLivedList<Offer> offers_;              // of the slots spoken of
  std::forward_list<FrameChange> left_by_no_; // offers of our own
  SlotReports reports_; // of slots that got a value: accepted
};

} // namespace parlour::dialogue
