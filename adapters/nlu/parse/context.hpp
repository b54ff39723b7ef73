// The session's context of a DoNLU, with names resolved (the end of
// runtime/base/understanding.hpp).
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

struct Context {
  TopicNumber asked_topic = no_topic;
  std::string asked_slot;                  // "" for none
  EntityId asked_entity_id = asked_entity; // that for none
  std::vector<Schema::Slot> said;          // of that topic, the latest last
  TopicNumber current = no_topic;
  TopicNumber resting = no_topic;
  std::vector<TopicNumber> unfinished;
  std::string grammar; // "" for all
  // Words of the question of yes or no that is asked; empty for none.
  std::vector<std::string> confirms;
  Now now;

  // What a topic gets for being expected (understanding, "Score"): 0.2 the
  // current one, 0.1 a resting or unfinished one.
  double bonus(TopicNumber topic) const;
};

inline constexpr double asked_bonus = 0.3;

// Names that are not there count as not given.
Context read_context(const Value& context, const Schema& schema);

} // namespace parlour::adapters::nlu
