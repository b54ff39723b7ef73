#include "adapters/nlu/understand/heard_texts.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t most_texts = 4;
// Of the words, by weight.
constexpr double nearly_all = 0.95;
constexpr double enough = 0.8;
constexpr double least_gain = 0.2;
constexpr double most_certain = 0.6;

// What can be said again in other words, without harm.
bool tells_or_asks(const Value& act) {
  const auto name = act[act_key::act].text();
  return name == "inform" || name == "request";
}

bool has_slots(const Value& act) {
  const auto* slots = act[act_key::slots].if_map();
  return slots && !slots->entries().empty();
}

bool is_known(const Value& slot) {
  if (const auto* items = slot[act_key::items].if_list())
    return std::ranges::all_of(*items, is_known);
  return !slot[act_key::unmatched] && (!slot[act_key::value].is_unknown() ||
                                       slot[act_key::candidates].if_list());
}

bool has_only_known_values(const Value& act) {
  const auto* slots = act[act_key::slots].if_map();
  return !slots || std::ranges::all_of(slots->entries(), [](const auto& slot) {
    return is_known(slot.second);
  });
}

// About what was asked, what is spoken of, or the same as before.
bool fits(const Value& act, const Understanding& best, const Value& context) {
  const auto& topic = act[act_key::topic];
  if (!best.acts.empty() && best.acts[0][act_key::topic] == topic)
    return true;
  const auto& asked = context["asked"];
  if (asked.is_unknown())
    return best.acts.empty() && !topic.is_unknown();
  return topic == asked["topic"] || topic == context["current"] ||
         (topic.is_unknown() &&
          !act[act_key::slots][asked["slot"].text()].is_unknown()) ||
         (best.acts.empty() && !topic.is_unknown());
}

double lower(const Value& confidence) {
  return std::min(most_certain, confidence.number_or(most_certain));
}

// The slot, with each of its values, at a lower confidence.
Value doubted(const Value& slot) {
  auto made = *slot.if_map();
  if (const auto* items = slot[act_key::items].if_list()) {
    List all;
    for (const auto& item : *items)
      all.push_back(doubted(item));
    made.set(act_key::items, std::move(all));
  } else {
    made.set(act_key::confidence, lower(slot[act_key::confidence]));
  }
  return made;
}

} // namespace

std::vector<std::string> other_texts(const Value& context,
                                     std::string_view text) {
  std::vector<std::string> others;
  const auto* heard = context["heard"].if_list();
  if (!heard)
    return others;
  for (const auto& each : *heard) {
    const auto* other = each.if_string();
    if (other && !other->empty() && *other != text &&
        others.size() < most_texts &&
        std::ranges::find(others, *other) == others.end())
      others.push_back(*other);
  }
  return others;
}

bool is_settled(const Understanding& best) {
  return std::ranges::any_of(
             best.acts, [](const auto& act) { return !tells_or_asks(act); }) ||
         (!best.acts.empty() && best.coverage >= enough &&
          std::ranges::all_of(best.acts, has_only_known_values));
}

bool makes_more_sense(const Understanding& other, const Understanding& best,
                      const Value& context) {
  const bool is_whole = other.coverage >= nearly_all && !other.acts.empty() &&
                        std::ranges::all_of(other.acts, [&](const Value& act) {
                          return tells_or_asks(act) && has_slots(act) &&
                                 has_only_known_values(act) &&
                                 fits(act, best, context);
                        });
  return is_whole && other.coverage >= best.coverage + least_gain;
}

void make_doubtful(Understanding& made) {
  for (auto& act : made.acts) {
    auto less_sure = *act.if_map();
    less_sure.set(act_key::confidence, lower(act[act_key::confidence]));
    Map slots;
    for (const auto& [name, slot] : act[act_key::slots].if_map()->entries())
      slots.set(name, doubted(slot));
    less_sure.set(act_key::slots, std::move(slots));
    act = std::move(less_sure);
  }
}

} // namespace parlour::adapters::nlu
