#include "adapters/nlu/acts/asides.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/text/words.hpp"

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

// "on Friday": a rule that has nothing but values and small words, and does not
// say which act it is, says no more than they do.
bool says_only_values(const BuiltAct& act, const Utterance& utterance) {
  if (act.is_declared || act.fills.empty() || act.act == "correct" ||
      act.act == "deny")
    return false;
  for (auto token = act.begin; token < act.end; ++token) {
    const auto& word = utterance.tokens.list[token].word;
    const bool is_value = std::ranges::any_of(act.fills, [&](const Fill& fill) {
      return fill.span && fill.begin <= token && token < fill.end;
    });
    if (!is_value && !utterance.filler[token] &&
        (!is_light(word) || word == "and"))
      return false;
  }
  return true;
}

// In "an appointment with Dr. Roth on Wednesday", nobody asks for the visiting
// hours of Wednesday: a value that another topic would take, unasked, in a
// clause that says what is wanted. Nor in "renew it, it's due on Wednesday": in
// a clause beside it that says something else.
bool is_explained(const BuiltAct& act, const std::vector<BuiltAct>& acts,
                  const Utterance& utterance, const Context& context) {
  if ((!act.is_aside && !says_only_values(act, utterance)) ||
      context.bonus(act.topic) > 0 || act.topic == context.asked_topic)
    return false;
  const auto clause =
      stretch_of(utterance.tokens, {act.begin, act.end}, Break::comma);
  const bool is_beside = (utterance.has_content(clause.begin, act.begin) ||
                          utterance.has_content(act.end, clause.end)) &&
                         std::ranges::none_of(acts, [&](const BuiltAct& other) {
                           return &other != &act && other.topic == act.topic;
                         });
  return std::ranges::any_of(acts, [&](const BuiltAct& other) {
    if (other.topic == act.topic)
      return false;
    const bool overlaps = other.begin < clause.end && clause.begin < other.end;
    return is_beside ? other.is_declared || context.expects(other.topic)
                     : other.is_declared && overlaps;
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
