#include "adapters/nlu/understand/alternatives.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/acts/act_value.hpp"

namespace parlour::adapters::nlu {

namespace {

// How close to the best score an alternative is. It is less than what the
// context is worth, so that of equals the expected topic wins. Scores are sums
// of decimals, hence a tolerance.
constexpr double alternative_range = 0.1;
constexpr double tolerance = 1e-6;

// The same slots from the same words.
bool equal_slots(const BuiltAct& left, const BuiltAct& right) {
  return left.act == right.act && left.fills.size() == right.fills.size() &&
         std::ranges::equal(left.fills, right.fills, {}, &Fill::slot,
                            &Fill::slot) &&
         std::ranges::equal(left.fills, right.fills, {}, &Fill::begin,
                            &Fill::begin) &&
         std::ranges::equal(left.fills, right.fills, {}, &Fill::end,
                            &Fill::end);
}

} // namespace

void add_alternative(Alternatives& alternatives, const BuiltAct& best,
                     std::vector<BuiltAct> acts) {
  if (acts.size() != 1 || acts[0].topic == no_topic ||
      acts[0].topic == best.topic ||
      acts[0].score < best.score - alternative_range + tolerance)
    return;
  alternatives.same_slots =
      alternatives.same_slots ||
      (equal_slots(best, acts[0]) && acts[0].score == best.score);
  alternatives.acts.push_back(std::move(acts[0]));
}

void add_alternatives(Understanding& made, const Alternatives& alternatives,
                      const Utterance& utterance, const Spans& spans,
                      const Schema& schema) {
  if (made.acts.size() != 1 || alternatives.acts.empty())
    return;
  auto first = *made.acts[0].if_map();
  List others;
  for (const auto& act : alternatives.acts)
    others.push_back(act_value(act, utterance, spans, schema));
  if (alternatives.same_slots)
    first.set(act_key::topic, Value());
  else
    first.set(act_key::alternatives, std::move(others));
  made.acts[0] = std::move(first);
}

} // namespace parlour::adapters::nlu
