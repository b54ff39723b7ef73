#include "adapters/nlu/parse/asides.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::nlu {

namespace {

// How much of the words of a further value must be understood.
constexpr double further_value = 0.6;

// "… and in the bedroom" is more of the same, "… and close the blinds in the
// bedroom" is something else.
bool is_something_else(const BuiltAct& act, const BuiltAct& before) {
  return act.elliptical && act.act != "correct" && act.topic == before.topic &&
         act.understood < further_value;
}

// In "an appointment with Dr. Roth on Wednesday", nobody asks for the visiting
// hours of Wednesday: a value that another topic would take, unasked, in a
// clause that says what is wanted.
bool is_explained(const BuiltAct& act, const std::vector<BuiltAct>& acts,
                  const Utterance& utterance, const Context& context) {
  if (!act.is_aside || context.bonus(act.topic) > 0 ||
      act.topic == context.asked_topic)
    return false;
  const auto clause =
      stretch_of(utterance.tokens, {act.begin, act.end}, Break::comma);
  return std::ranges::any_of(acts, [&](const BuiltAct& other) {
    return other.is_declared && other.topic != act.topic &&
           other.begin < clause.end && clause.begin < other.end;
  });
}

} // namespace

void drop_asides(std::vector<BuiltAct>& acts, const Utterance& utterance,
                 const Context& context) {
  std::vector<BuiltAct> kept;
  for (const auto& act : acts)
    if (!is_explained(act, acts, utterance, context) &&
        (kept.empty() || !is_something_else(act, kept.back())))
      kept.push_back(act);
  acts = std::move(kept);
}

} // namespace parlour::adapters::nlu
