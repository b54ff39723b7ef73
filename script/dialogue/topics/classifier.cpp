#include "script/dialogue/topics/classifier.hpp"

#include <algorithm>
#include <array>

namespace parlour::dialogue {

namespace {

// How much worse than the best an alternative may be (understanding, "Score").
// With less, the robot decides by chance between equals; with more, it asks
// about readings that nobody meant.
constexpr double clarify_within = 0.1;

bool may_be_chosen(const script::Program& program, TopicId topic,
                   const ClassifierContext& context) {
  const auto& out = context.unregistered;
  return topic < program.topics.size() &&
         std::find(out.begin(), out.end(), topic) == out.end();
}

// The topic that the act names; no_id: none, or one that takes no part now.
TopicId named(const script::Program& program, const Act& act,
              const ClassifierContext& context) {
  auto topic = act.topic.empty() ? script::no_id : program.topic(act.topic);
  return may_be_chosen(program, topic, context) ? topic : script::no_id;
}

// How many of the act's slots the topic has, by name.
std::size_t slots_of(const script::Topic& topic, const Act& act) {
  return static_cast<std::size_t>(std::count_if(
      act.slots.begin(), act.slots.end(), [&](const SlotValue& value) {
        return topic.slot(value.slot) != script::no_id;
      }));
}

// Only a topic with more slots than the best so far takes its place, so the
// order of asking decides between equals. A topic that has all of them ends the
// search.
TopicId by_slots(const script::Program& program, const Act& act,
                 const ClassifierContext& context) {
  auto best = script::no_id;
  std::size_t max_count = 0;
  auto consider = [&](TopicId topic) { // the likeliest first, some twice
    if (max_count == act.slots.size() ||
        !may_be_chosen(program, topic, context))
      return;
    const auto count = slots_of(program.topics[topic], act);
    if (count > max_count) {
      max_count = count;
      best = topic;
    }
  };
  for (auto topic : {context.asked, context.current, context.resting})
    consider(topic);
  for (auto topic : context.unfinished)
    consider(topic);
  consider(context.completed);
  for (TopicId topic = 0; topic < program.topics.size(); ++topic)
    consider(topic);
  return best;
}

// Without confidences nothing is near: there is nothing to compare. The 1e-9 is
// for 0.8 and 0.7, whose difference is a little more than 0.1 in binary.
bool is_near(const Act& best, const Act& other) {
  return !best.confidence.is_unknown() && !other.confidence.is_unknown() &&
         best.confidence.number_or(0) - other.confidence.number_or(0) <=
             clarify_within + 1e-9;
}

// A whole sentence without slots ("what is that?") is no follow-up, so only the
// topic that asks may have it.
TopicId without_slots(const script::Program& program, const Act& act,
                      const ClassifierContext& context) {
  std::array topics{context.asked, script::no_id, script::no_id};
  if (act.elliptical)
    topics = {context.asked, context.resting, context.current};
  for (auto topic : topics)
    if (may_be_chosen(program, topic, context))
      return topic;
  return script::no_id;
}

// Values that nobody knows, and nothing else.
bool is_in_vain(const Act& act) {
  return !act.slots.empty() &&
         std::ranges::all_of(act.slots, &SlotValue::unmatched);
}

} // namespace

TopicId classify(const script::Program& program, const Act& act,
                 const ClassifierContext& context) {
  auto topic = named(program, act, context);
  if (topic != script::no_id)
    return topic;
  return act.slots.empty() ? without_slots(program, act, context)
                           : by_slots(program, act, context);
}

void prefer_resting(const script::Program& program, Act& act,
                    const ClassifierContext& context) {
  const auto topic = classify(program, act, context);
  if (!act.elliptical || context.resting == script::no_id ||
      topic == context.resting || topic == context.asked ||
      topic == context.current)
    return;
  for (const auto& other : act.alternatives)
    if (classify(program, other, context) == context.resting &&
        is_near(act, other)) {
      auto chosen = other;
      chosen.text = act.text;
      chosen.elliptical = true;
      act = std::move(chosen);
      return;
    }
}

void prefer_known(Act& act) {
  auto& others = act.alternatives;
  const auto known = !is_in_vain(act)
                         ? others.end()
                         : std::ranges::find_if(others, [&](const Act& other) {
                             return !other.slots.empty() &&
                                    !is_in_vain(other) && is_near(act, other);
                           });
  if (known != others.end()) {
    auto chosen = *known;
    chosen.text = act.text;
    others.erase(known);
    chosen.alternatives = std::move(others);
    act = std::move(chosen);
  }
  if (!is_in_vain(act))
    std::erase_if(act.alternatives, is_in_vain);
}

std::vector<TopicId> clarify(const script::Program& program, const Act& act,
                             const ClassifierContext& context) {
  std::vector<TopicId> topics{classify(program, act, context)};
  const bool goes_on = act.elliptical && topics.front() == context.resting;
  if (topics.front() == script::no_id || act.confidence.is_unknown() || goes_on)
    return {};
  for (const auto& other : act.alternatives) {
    auto topic = classify(program, other, context);
    if (topic != script::no_id && is_near(act, other) &&
        std::find(topics.begin(), topics.end(), topic) == topics.end())
      topics.push_back(topic);
  }
  return topics.size() > 1 ? topics : std::vector<TopicId>{};
}

} // namespace parlour::dialogue
