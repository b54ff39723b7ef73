// FillingEvent: what an utterance says about the slots of one frame, in the
// order of engine rule 5: corrections and denials; values matched to their
// cardinality in slot order; constraints, each once; grounding. An internal
// part of apply (frame.hpp).
#pragma once

#include <forward_list>
#include <memory>
#include <vector>

#include "script/dialogue/frame/matching.hpp"
#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::dialogue {

// The slot has this value for certain; doubts and failures are forgotten.
void accept_value(SlotState& slot, Value value);

// The slot has no value; how often it was asked for stays.
void empty_slot(SlotState& slot);

// An unconfirmed value goes, the one accepted before it comes back; another
// value just goes.
void take_back(SlotState& slot);

// accepted, corrected or unchanged.
SlotOutcome outcome_of_change(const Value& before, const Value& after);

// Refers to all that it is given; lives for one event.
class FillingEvent {
public:
  FillingEvent(const script::Program& program, TopicFrame& frame,
               const FrameEvaluator& evaluate);

  // A fill, correct or deny. A correction stands against later fills; a
  // denial takes back an equal value said before it in the same event.
  void take(const FrameChange& change);

  // Changes the frame; one report for each slot that was spoken of. Errors of
  // constraints are appended.
  SlotReports run(std::vector<Error>& errors);

private:
  // What was said of a slot, and how the slot was before.
  struct Offer {
    SlotId slot;
    const FrameChange* change = nullptr; // null: only denials
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
  bool denies(const FrameChange& denial, const Value& value) const;
  void narrow(Offer& offer, const FrameChange& denial);

  void match_offer(SlotId slot, const FrameChange& change);
  void put_value(SlotId slot, const FrameChange& change, const Value& value);
  void put_candidates(SlotId slot, const FrameChange& change, List candidates);

  void check(const script::Constraint& constraint, std::vector<Error>& errors);
  bool judged(const std::vector<SlotId>& reads) const;
  void refuse(const std::vector<SlotId>& reads, const std::string& reason);

  void ground_value(SlotReport& report);
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
