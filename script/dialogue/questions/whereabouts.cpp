#include "script/dialogue/questions/whereabouts.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/context/asked.hpp"

namespace parlour::dialogue {

namespace {

bool is_said(SlotOutcome outcome) {
  return outcome != SlotOutcome::cleared && outcome != SlotOutcome::rejected;
}

// What will be asked for again.
bool is_doubtful(SlotOutcome outcome) {
  return outcome == SlotOutcome::refused ||
         outcome == SlotOutcome::unconfirmed ||
         outcome == SlotOutcome::ambiguous;
}

} // namespace

// A <confirm> asks for no slot, so no topic counts as asking then. A topic that
// is being completed counts as current where there is no other.
ClassifierContext Whereabouts::classifier_context() const {
  ClassifierContext context;
  if (question_ && question_->heard &&
      question_->purpose != Asked::For::yes_or_no) {
    context.asked = question_->topic;
    context.asked_slot = question_->slot;
  }
  context.current =
      frames_.order().current().value_or(confirmations_.completing());
  context.resting = frames_.resting().value_or(script::no_id);
  context.unfinished = frames_.order().suspended();
  if (const auto latest = frames_.order().latest();
      latest && frames_[*latest].status == TopicStatus::completed)
    context.completed = *latest;
  context.unregistered = frames_.order().deaf();
  return context;
}

TopicId Whereabouts::topic_of(const Act& act) const {
  const auto named = context_.program->topic(act.topic);
  return named != script::no_id && frames_.order().takes_acts(named)
             ? named
             : classify(*context_.program, act, classifier_context());
}

// The latest last, for "no, four": the slot that was said last is the likeliest
// one to be corrected. None where the last turn has answered what is asked,
// though not well: a correction is of that.
List Whereabouts::names_said_before(SlotId asked) const {
  List names;
  if (said_.slots.empty() || said_.slots.back() == asked)
    return names;
  const auto& slots = frames_[said_.topic].slots;
  for (auto slot : said_.slots)
    if (slot != asked && slots[slot].status != SlotStatus::empty)
      names.emplace_back(context_.topic(said_.topic).slots[slot].name);
  return names;
}

// The question's own goes before the state's: without it, the question could
// not be answered.
const std::string&
Whereabouts::narrowing_grammar(const ClassifierContext& context) const {
  static const std::string none;
  if (context.asked != script::no_id && context.asked_slot != script::no_id)
    if (const auto& own =
            context_.topic(context.asked).slots[context.asked_slot].grammar;
        !own.empty())
      return own;
  const auto* state = context_.active_state();
  return state ? state->grammar : none;
}

// The words of the question that a yes or no would be for; null: none.
const std::string* Whereabouts::yes_or_no_asked() const {
  if (question_)
    return question_->wants_yes_or_no() ? &question_->words : nullptr;
  const auto* confirm = confirmations_.latest_confirm();
  return confirm ? &confirm->question : nullptr;
}

// The topic whose question something else came between; no_id: there is none,
// or something is asked now.
TopicId Whereabouts::waiting_topic(const ClassifierContext& context) const {
  if (question_ || yes_or_no_asked() || context.unfinished.empty())
    return script::no_id;
  const auto topic = context.unfinished.front();
  const auto slot = question_.slot_asked_for(topic);
  return slot != script::no_id && frames_[topic].slots[slot].asked > 0
             ? topic
             : script::no_id;
}

// What the user may call the slots of which the robot has asked whether they
// are right, and which it can ask for.
Map Whereabouts::names_of_slots(TopicId topic) const {
  Map names;
  const auto& slots = context_.topic(topic).slots;
  for (SlotId slot = 0; slot < slots.size(); ++slot)
    if (frames_[topic].slots[slot].applies &&
        slots[slot].question != script::no_code)
      if (const auto label = words_.label_of(topic, slot); label.if_string())
        names.set(slots[slot].name, label);
  return names;
}

Value Whereabouts::understanding_context() const {
  const auto context = classifier_context();
  auto name = [&](TopicId topic) {
    return topic == script::no_id ? Value() : Value(context_.topic(topic).name);
  };
  Map result;
  if (context.asked != script::no_id && context.asked_slot != script::no_id) {
    const auto& slot = context_.topic(context.asked).slots[context.asked_slot];
    result.set("asked",
               Map{{"topic", name(context.asked)}, {"slot", slot.name}});
    if (const auto& offered =
            frames_[context.asked].slots[context.asked_slot].candidates;
        !offered.empty())
      result.set("choices", offered);
    if (said_.topic == context.asked)
      result.set("said", names_said_before(context.asked_slot));
  }
  if (const auto topic = waiting_topic(context); topic != script::no_id) {
    const auto slot = question_.slot_asked_for(topic);
    result.set("waiting",
               Map{{"topic", name(topic)},
                   {"slot", context_.topic(topic).slots[slot].name}});
  }
  result.set("current", name(context.current));
  result.set("resting", name(context.resting));
  List unfinished;
  for (auto topic : context.unfinished)
    unfinished.push_back(name(topic));
  result.set("unfinished", unfinished);
  if (context.completed != script::no_id)
    result.set("completed", name(context.completed));
  if (const auto& grammar = narrowing_grammar(context); !grammar.empty())
    result.set("grammar", grammar);
  if (const auto* question = yes_or_no_asked())
    result.set("confirms", *question);
  if (question_ && question_->asks_for_changes())
    result.set("changes", Map{{"topic", name(question_->topic)},
                              {"slots", names_of_slots(question_->topic)}});
  result.set("now", context_.now);
  return result;
}

// Slots that are in doubt go behind the others of the same act: they will be
// asked for, and a correction is most likely about them. Acts about the same
// topic add up; another topic begins anew.
void Whereabouts::note_what_was_said(const steps::Fill& step,
                                     const FrameResult& result) {
  if (!step.act) // a yes or no
    return;
  if (std::exchange(said_.topic, step.topic) != step.topic)
    said_.slots.clear();
  for (const bool doubtful : {false, true})
    for (const auto& report : result.reports)
      if (is_said(report.outcome) && is_doubtful(report.outcome) == doubtful) {
        std::erase(said_.slots, report.slot);
        said_.slots.push_back(report.slot);
      }
}

// A topic whose <completed> still waits counts as unfinished, although the
// order of topics has forgotten it.
std::vector<TopicId> Whereabouts::unfinished() const {
  auto topics = frames_.order().suspended();
  if (auto current = frames_.order().current();
      current && frames_.order().unfinished(*current))
    topics.insert(topics.begin(), *current);
  if (const auto topic = confirmations_.completing(); topic != script::no_id)
    topics.insert(topics.begin(), topic);
  return topics;
}

Value Whereabouts::status_of(TopicId topic) const {
  if (topic == script::no_id)
    return {};
  return name_of(confirmations_.is_completing(topic) ? TopicStatus::active
                                                     : frames_[topic].status);
}

bool Whereabouts::goes_on(TopicId topic) const {
  if (confirmations_.is_completing(topic))
    return true;
  const auto status = frames_[topic].status;
  return status == TopicStatus::active || status == TopicStatus::suspended ||
         status == TopicStatus::resting;
}

List Whereabouts::unfinished_names() const {
  List names;
  for (auto topic : unfinished())
    names.emplace_back(context_.topic(topic).name);
  return names;
}

} // namespace parlour::dialogue
