// TopicFrame: the slots of one topic in one session, as a value, and the pure
// function that changes it. The session owns it (frames.hpp); the topic frame's
// actor is sent it, computes the next one, and keeps none (engine rule 5.12).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"
#include "script/program/program.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

using script::CodeId;
using script::SlotId;
using script::TopicId;

// Only `filled` counts for _FrameDone and for queries.
enum class SlotStatus : std::uint8_t {
  empty,
  filled,      // accepted
  unconfirmed, // has a value; waits for the answer to an explicit confirmation
  ambiguous,   // several candidates
};

// One slot of a frame. What survives when the slot is emptied is in
// empty_slot() (filling_event.hpp).
struct SlotState {
  Value value; // what `this.X` reads; unknown unless filled or unconfirmed
  SlotStatus status = SlotStatus::empty;
  Value confidence; // 0..1 or unknown
  std::string text; // the words
  List candidates;
  Value previous;          // accepted before; back on "no" or on doubt
  bool implicit = false;   // to be echoed in the next output
  bool by_default = false; // from the slot's expr; not an answer
  bool offered = false;    // what the slot offers: not twice
  bool applies = true;     // what its `if` came to
  bool certain = false;    // the words that filled it were sure and matched
  bool closed = false;     // of many: nothing more is wanted
  bool wants_more = false; // of many: the user said so
  std::uint32_t asked = 0; // questions released
  std::uint32_t no_input = 0;
  std::uint32_t no_match = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(status, SlotStatus::ambiguous);
    archive(value, confidence, text, candidates, previous, implicit, by_default,
            offered, applies, certain, closed, wants_more, asked, no_input,
            no_match);
  }
};

enum class TopicStatus : std::uint8_t {
  untouched,
  active,    // current, or needed by the current one
  suspended, // unfinished; another topic took over
  resting,   // an enquiry that was answered; its slots are context
  completed,
  cancelled,
};

std::string_view name_of(TopicStatus status);

// What one session knows about one topic. Whoever has it as a FramePointer may
// keep it as long as it likes: such a frame is never changed.
struct TopicFrame {
  TopicId topic = script::no_id;
  TopicStatus status = TopicStatus::untouched;
  std::vector<SlotState> slots; // one for each slot of the topic
  bool done = false;            // _FrameDone
  bool sure = false;    // the last act was a certain and complete sentence
  bool certain = false; // and said, for certain, all that is asked for
  Value last;           // `this.last`, of a topic that was completed before
  Value rows;           // of the last answered query
  Value asked;          // map of the conditions it was asked with
  std::vector<std::string> relaxed; // slots that its answer left out
  // Of initial values: the next event with values reports them.
  std::vector<Error> errors;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.topic(topic);
    archive.up_to(status, TopicStatus::cancelled);
    archive(slots, done, sure, certain, last, rows, asked, relaxed, errors);
    archive.has_slots(topic, slots.size());
  }
};

using FramePointer = std::shared_ptr<const TopicFrame>;

// One thing that happens to a frame. Plain data: it travels to the actor. Which
// fields a kind uses stands with the kind or follows from it; the others keep
// their initial values.
struct FrameChange {
  enum class Kind : std::uint8_t {
    fill,         // a value from the user: matched, constrained, grounded
    correct,      // the same, for a value that was there (a correction)
    deny,         // "no, not X": empties the slot if it holds that value
    set,          // by a script's <set>: accepted as it is
    clear,        // empties the slot
    reset,        // empties the whole frame, status too
    confirmed,    // the user said yes to an explicit confirmation
    disconfirmed, // the user said no
    asked,        // the slot's question was released
    no_input,
    no_match,
    status,   // `status` becomes the frame's
    answered, // a query's outcome: rows in `value`, asked, relaxed
    inherit,  // empties every slot but those in `keep` (a full request to a
              // resting enquiry keeps none; an elliptical one keeps all but
              // the relaxed)
    echoed,   // implicit marks were used in an output
    offer,    // the slot's offered value, which waits for a yes
    said,     // an act begins: `value`, whether it is certain and complete
    close,    // nothing more is wanted of a slot with several values
    reopen,   // something more is
  };
  Kind kind = Kind::set;
  SlotId slot = script::no_id;
  Value value{};
  Value confidence{};
  std::string text{};
  List candidates{};
  bool unmatched = false; // words that stand where a value was expected
  Value amount{};         // of one of many values; unknown: not said
  bool more = false;      // so many in addition
  bool heard = false;     // the words only sound like the value
  TopicStatus status = TopicStatus::active;
  Value asked{};
  std::vector<std::string> relaxed{};
  std::vector<SlotId> keep{};

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(kind, Kind::reopen);
    archive.up_to(status, TopicStatus::cancelled);
    archive(slot, value, confidence, text, candidates, unmatched, amount, more,
            heard, asked, relaxed, keep);
  }
};

// All that apply() needs besides the program, so that an actor which keeps
// nothing can compute the next frame.
struct FrameRequest {
  FramePointer frame;               // as the session has it; never null
  std::vector<FrameChange> changes; // of one event, in order
  Timestamp now = 0;
  // Session variables, for constraints that read them; may be null.
  std::shared_ptr<const List> variables;
  // Frames of topics whose slots others read; those that were touched.
  std::vector<FramePointer> others{};

  template <class Archive>
  void serialize(Archive& archive) {
    archive(frame, changes, now, variables, others);
    archive.needs(frame);
    for (const auto& other : others)
      archive.needs(other);
    for (const auto& change : changes) {
      archive.is_slot(frame ? frame->topic : script::no_id, change.slot);
      for (auto kept : change.keep)
        archive.is_there(frame ? frame->topic : script::no_id, kept);
    }
  }
};

// What became of a slot in an event.
enum class SlotOutcome : std::uint8_t {
  accepted,
  corrected,   // accepted in place of another value
  unconfirmed, // must be asked for by an explicit confirmation
  ambiguous,   // "do you mean A or B?"
  refused,     // not in its cardinality, or a constraint said no: the old
               // value stays
  rejected,    // confidence too low: as if it had not been said
  cleared,
  unchanged, // the same value again
};

std::string_view name_of(SlotOutcome outcome);

// What became of one slot: at most one report a slot and event.
struct SlotReport {
  SlotId slot = script::no_id;
  SlotOutcome outcome = SlotOutcome::accepted;
  Value before;
  Value offered;      // what was said, where it was refused
  std::string reason; // a constraint's message; empty: the cardinality

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(outcome, SlotOutcome::unchanged);
    archive(slot, before, offered, reason);
  }
};

using SlotReports = ShortLivedList<SlotReport>;

// What an event has come to. Which scripts run follows from the reports, in the
// session; while the event was computed, nothing ran but conditions and texts.
struct FrameResult {
  FramePointer frame;
  SlotReports reports;            // in slot order
  SlotId missing = script::no_id; // the first Functional slot not accepted
  bool query_slot_filled = false; // one that a <by> uses, by this event
  std::vector<Error> errors;      // of constraints: they count as failing

  template <class Archive>
  void serialize(Archive& archive) {
    archive(frame, reports, missing, query_slot_filled, errors);
  }
};

// Evaluates a condition or text of the topic against a frame under
// construction. The slots that it reads are appended to `reads`, unless null.
// An error is that of the script; it has no effect but its return.
using FrameEvaluator = std::function<Expected<Value>(
    CodeId code, const TopicFrame& frame, std::vector<SlotId>* reads)>;

// The slot with its initial value (its `expr`). An expr that fails is unknown,
// and an error of the frame.
SlotState new_slot(const script::Slot& slot, TopicFrame& frame,
                   const FrameEvaluator& evaluate);

// A new frame with the slots' initial values.
TopicFrame new_frame(const script::Program& program, TopicId topic,
                     const FrameEvaluator& evaluate);

// Whether each slot applies, by its `if`; one that fails does not. Errors are
// appended to `errors`, unless null.
void judge_conditions(const script::Topic& topic, TopicFrame& frame,
                      const FrameEvaluator& evaluate,
                      std::vector<Error>* errors);

// Whether more may be wanted of a slot with several values: it has a `more`
// question that was not answered with no yet (engine rule 5.14).
bool is_open(const script::Slot& slot, const SlotState& state);

// The first Functional slot that applies and is not accepted, or is open, in
// slot order; or no_id.
SlotId missing_slot(const script::Topic& topic, const TopicFrame& frame);

// One event, in the order of engine rule 5.4: corrections and denials; values
// matched in slot order; constraints, each once; grounding. A constraint that
// reads a slot without value cannot be judged yet. A failing one refuses those
// of this event's slots that it reads (all, where it reads none). The request's
// frame stays as it is.
FrameResult apply(const script::Program& program, const FrameRequest& request,
                  const FrameEvaluator& evaluate);

// The same in place; the result has no frame.
FrameResult apply_in_place(const script::Program& program, TopicFrame& frame,
                           std::span<const FrameChange> changes,
                           const FrameEvaluator& evaluate);

// What needs no more than the frame, in place: its status; a question of this
// slot that was released.
void set_status(const script::Topic& topic, TopicFrame& frame,
                TopicStatus status);
void count_question(TopicFrame& frame, SlotId slot);

} // namespace parlour::dialogue
