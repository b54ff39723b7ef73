// The event that changes a frame: changes in order, of which rows of fills,
// corrections and denials are one filling event each (filling_event.hpp).
#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "script/dialogue/frame/filling_event.hpp"
#include "script/dialogue/frame/matching.hpp"
#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::dialogue {

namespace {

using Kind = FrameChange::Kind;

// _FrameDone: all Functional slots accepted, of a frame that was begun.
void settle(const script::Topic& topic, TopicFrame& frame) {
  const bool begun =
      frame.status != TopicStatus::untouched ||
      std::any_of(frame.slots.begin(), frame.slots.end(),
                  [](const SlotState& slot) {
                    return slot.status != SlotStatus::empty && !slot.by_default;
                  });
  frame.done = begun && missing_slot(topic, frame) == script::no_id;
}

// For `this.last`.
Value values_of(const script::Topic& topic, const TopicFrame& frame) {
  Map values;
  for (SlotId slot = 0; slot < frame.slots.size(); ++slot)
    if (frame.slots[slot].status == SlotStatus::filled)
      values.set(topic.slots[slot].name, frame.slots[slot].value);
  return values;
}

bool is_filling(Kind kind) {
  return kind == Kind::fill || kind == Kind::correct || kind == Kind::deny;
}

// One event of a frame, in place. Reports of all its changes are put together,
// one a slot, so that scripts run once for what the user said once.
class Event {
public:
  Event(const script::Program& program, TopicFrame& frame,
        const FrameEvaluator& evaluate)
      : program_(program), topic_(program.topics[frame.topic]), frame_(frame),
        evaluate_(evaluate) {}

  // A row of fills, corrections and denials is taken as a whole, because a
  // later one may change what an earlier one means. Which slots apply, and
  // whether the frame is done, is found at the end, once.
  void run(std::span<const FrameChange> changes) {
    for (auto at = changes.begin(); at != changes.end();) {
      if (!is_filling(at->kind)) {
        change(*at++);
        continue;
      }
      FillingEvent filling(program_, frame_, evaluate_);
      for (; at != changes.end() && is_filling(at->kind); ++at)
        filling.take(*at);
      add(filling.run(errors_));
      told_ = true;
    }
    judge_conditions(topic_, frame_, evaluate_, &errors_);
    settle(topic_, frame_);
    if (told_) {
      frame_.certain = frame_.sure && is_certain();
      std::ranges::move(std::exchange(frame_.errors, {}),
                        std::back_inserter(errors_));
    }
  }

  SlotReports reports() {
    std::sort(reports_.begin(), reports_.end(),
              [](const auto& a, const auto& b) { return a.slot < b.slot; });
    return std::move(reports_);
  }

  // All but the frame.
  FrameResult result() {
    FrameResult result;
    result.missing = missing_slot(topic_, frame_);
    result.query_slot_filled =
        std::any_of(reports_.begin(), reports_.end(),
                    [&](const auto& report) { return asks_query(report); });
    result.reports = reports();
    result.errors = std::move(errors_);
    return result;
  }

private:
  void add(SlotReports reports) {
    if (reports_.empty())
      reports_ = std::move(reports);
    else
      for (auto& report : reports)
        add(std::move(report));
  }

  // One report a slot: what it was before the event, what became of it last.
  void add(SlotReport report) {
    auto found =
        std::find_if(reports_.begin(), reports_.end(), [&](const auto& known) {
          return known.slot == report.slot;
        });
    if (found == reports_.end()) {
      reports_.push_back(std::move(report));
      return;
    }
    report.before = std::move(found->before);
    *found = std::move(report);
  }

  void add(SlotId slot, SlotOutcome outcome, Value before) {
    SlotReport report;
    report.slot = slot;
    report.outcome = outcome;
    report.before = std::move(before);
    add(std::move(report));
  }

  void change(const FrameChange& change) {
    switch (change.kind) {
    case Kind::reset:
      reset();
      break;
    case Kind::status:
      frame_.status = change.status;
      break;
    case Kind::answered:
      frame_.rows = change.value;
      frame_.asked = change.asked;
      frame_.relaxed = change.relaxed;
      break;
    case Kind::inherit:
      inherit(change.keep);
      break;
    case Kind::echoed:
      echoed(change.slot);
      break;
    case Kind::said:
      frame_.sure = bool(change.value);
      told_ = true;
      break;
    default:
      if (change.slot < frame_.slots.size())
        change_slot(change, frame_.slots[change.slot]);
    }
  }

  void change_slot(const FrameChange& change, SlotState& slot) {
    switch (change.kind) {
    case Kind::set:
      set(change, slot);
      break;
    case Kind::clear:
      clear(change.slot);
      break;
    case Kind::confirmed:
      confirmed(change.slot, slot);
      break;
    case Kind::disconfirmed:
      disconfirmed(change.slot, slot);
      break;
    case Kind::offer:
      offer(change, slot);
      break;
    case Kind::close:
      slot.closed = true;
      break;
    case Kind::reopen:
      slot.wants_more = true;
      break;
    case Kind::asked:
      ++slot.asked;
      break;
    case Kind::no_input:
      ++slot.no_input;
      break;
    case Kind::no_match:
      ++slot.no_match;
      break;
    default:
      break;
    }
  }

  // The topic begins anew, but `this.last` stays: it is about the time before.
  void reset() {
    for (SlotId slot = 0; slot < frame_.slots.size(); ++slot)
      if (!frame_.slots[slot].value.is_unknown())
        add(slot, SlotOutcome::cleared, frame_.slots[slot].value);
    auto last = std::move(frame_.last);
    frame_ = new_frame(program_, frame_.topic, evaluate_);
    frame_.last = std::move(last);
  }

  // An enquiry forgets what its next question does not inherit (engine rule
  // 6.5).
  void inherit(const std::vector<SlotId>& keep) {
    for (SlotId slot = 0; slot < frame_.slots.size(); ++slot)
      if (std::find(keep.begin(), keep.end(), slot) == keep.end())
        begin_anew(slot);
  }

  // Back to the initial value; how often it was asked for stays.
  void begin_anew(SlotId id) {
    auto& slot = frame_.slots[id];
    auto before = slot.value;
    if (!before.is_unknown() && !slot.by_default)
      add(id, SlotOutcome::cleared, std::move(before));
    auto fresh = new_slot(topic_.slots[id], frame_, evaluate_);
    fresh.asked = slot.asked;
    slot = std::move(fresh);
  }

  // By a script, or by a topic that begins with values: neither matched nor
  // grounded. Unknown empties the slot.
  void set(const FrameChange& change, SlotState& slot) {
    if (change.value.is_unknown()) {
      clear(change.slot);
      return;
    }
    auto before = slot.value;
    accept_value(slot, change.value);
    slot.confidence = change.confidence;
    slot.text = change.text;
    add(change.slot, outcome_of_change(before, slot.value), before);
  }

  void clear(SlotId id) {
    auto& slot = frame_.slots[id];
    auto before = slot.value;
    empty_slot(slot);
    if (!before.is_unknown())
      add(id, SlotOutcome::cleared, std::move(before));
  }

  // A yes that comes when nothing is in doubt any more has no effect.
  void confirmed(SlotId id, SlotState& slot) {
    if (slot.status != SlotStatus::unconfirmed)
      return;
    auto before = slot.previous;
    accept_value(slot, slot.value);
    add(id, outcome_of_change(before, slot.value), before);
  }

  void disconfirmed(SlotId id, SlotState& slot) {
    if (slot.status != SlotStatus::unconfirmed)
      return;
    auto offered = slot.value;
    take_back(slot);
    add(id, SlotOutcome::cleared, std::move(offered));
  }

  // Once, and only what the slot takes.
  void offer(const FrameChange& change, SlotState& slot) {
    slot.offered = true;
    const auto matched =
        match(topic_.slots[change.slot], change,
              {[this](CodeId code) { return evaluate_(code, frame_, nullptr); },
               &program_});
    if (matched.value.is_unknown())
      return;
    slot.value = matched.value;
    slot.status = SlotStatus::unconfirmed;
    slot.confidence = {};
    slot.text.clear();
    add(change.slot, SlotOutcome::unconfirmed, {});
  }

  // Whether this event said all that is asked for, and whatever it said for
  // certain.
  bool is_certain() const {
    for (SlotId slot = 0; slot < frame_.slots.size(); ++slot) {
      const bool is_said = was_said(slot);
      const bool is_wanted =
          topic_.slots[slot].functional && frame_.slots[slot].applies;
      if ((is_wanted && !is_said) || (is_said && !frame_.slots[slot].certain))
        return false;
    }
    return true;
  }

  bool was_said(SlotId slot) const {
    return std::ranges::any_of(reports_, [&](const SlotReport& report) {
      return report.slot == slot && (report.outcome == SlotOutcome::accepted ||
                                     report.outcome == SlotOutcome::corrected ||
                                     report.outcome == SlotOutcome::unchanged);
    });
  }

  void echoed(SlotId slot) {
    for (SlotId id = 0; id < frame_.slots.size(); ++id)
      if (slot == script::no_id || slot == id)
        frame_.slots[id].implicit = false;
  }

  // Whether the slot was given a value that a <by> of the topic uses.
  bool asks_query(const SlotReport& report) const {
    const bool has_value = report.outcome == SlotOutcome::accepted ||
                           report.outcome == SlotOutcome::corrected ||
                           report.outcome == SlotOutcome::unchanged;
    return has_value &&
           std::any_of(
               topic_.queries.begin(), topic_.queries.end(),
               [&](const auto& query) { return uses(query, report.slot); });
  }

  static bool uses(const script::KnowledgeSource& query, SlotId slot) {
    return std::any_of(query.by.begin(), query.by.end(),
                       [&](const auto& by) { return by.slot == slot; });
  }

  const script::Program& program_;
  const script::Topic& topic_;
  TopicFrame& frame_;
  const FrameEvaluator& evaluate_;
  SlotReports reports_;
  std::vector<Error> errors_;
  bool told_ = false; // by the user
};

} // namespace

FrameResult apply_in_place(const script::Program& program, TopicFrame& frame,
                           std::span<const FrameChange> changes,
                           const FrameEvaluator& evaluate) {
  Event event(program, frame, evaluate);
  event.run(changes);
  return event.result();
}

FrameResult apply(const script::Program& program, const FrameRequest& request,
                  const FrameEvaluator& evaluate) {
  auto changed = std::make_shared<TopicFrame>(*request.frame);
  auto result = apply_in_place(program, *changed, request.changes, evaluate);
  result.frame = std::move(changed);
  return result;
}

void set_status(const script::Topic& topic, TopicFrame& frame,
                TopicStatus status) {
  frame.status = status;
  if (status == TopicStatus::completed)
    frame.last = values_of(topic, frame);
  settle(topic, frame);
}

void count_question(TopicFrame& frame, SlotId slot) {
  ++frame.slots[slot].asked;
}

} // namespace parlour::dialogue
