// The context of the session that comes with DoNLU, with names resolved to
// numbers. The keys are listed at the end of runtime/message/understanding.hpp.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

// What an act gets that fills the slot which was asked for.
inline constexpr double asked_bonus = 0.3;

struct Context {
  TopicNumber asked_topic = no_topic;
  // The slot that the last question asks for; empty: none.
  std::string asked_slot;
  // Its kind of value; asked_entity if there is no question.
  EntityId asked_entity_id = asked_entity;
  // What was asked before something else came between, where nothing is asked.
  TopicNumber waiting_topic = no_topic;
  std::string waiting_slot;
  // The slots of that topic that were filled before, the latest last.
  std::vector<Schema::Slot> said;
  TopicNumber current = no_topic;
  TopicNumber resting = no_topic;
  std::vector<TopicNumber> unfinished;
  TopicNumber completed = no_topic; // last
  // The only grammar to be tried; empty: all.
  std::string grammar;
  // The words of the question to which a yes or no is expected; empty: none.
  std::vector<std::string> confirms;
  // The slots of which it was asked whether they are right, each with what it
  // is called.
  struct NamedSlot {
    std::string slot;
    std::vector<std::string> words;
  };
  TopicNumber changes_topic = no_topic;
  std::vector<NamedSlot> changes;
  // What the last question offers ("Do you mean A or B?"); empty: nothing.
  std::vector<std::string> choices;
  Now now;
  // A recogniser has heard the words, so that names may be written wrongly.
  bool heard = false;

  // What an act about the topic gets for being expected (understanding,
  // "Score"): 0.2 for the current topic, 0.1 for a resting or unfinished one,
  // or the one that was completed last.
  double bonus(TopicNumber topic) const;
  // Whether an act about it gets anything.
  bool expects(TopicNumber topic) const {
    return topic == asked_topic || bonus(topic) > 0;
  }
  bool expects_any(const std::vector<TopicNumber>& topics) const {
    return std::ranges::any_of(
        topics, [this](TopicNumber topic) { return expects(topic); });
  }
  // Half of asked_bonus, for the slot whose question waits.
  double waiting_bonus(TopicNumber topic, bool fills_it) const;
  // Whether the conversation is at it: it is asked for, current or unfinished.
  bool goes_on(TopicNumber topic) const;
};

// Names that the schema does not have are ignored.
Context read_context(const Value& context, const Schema& schema);

} // namespace parlour::adapters::nlu
