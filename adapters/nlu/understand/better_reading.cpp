#include "adapters/nlu/understand/better_reading.hpp"

#include <algorithm>

#include "adapters/nlu/text/word_set.hpp"
#include "adapters/nlu/understand/hypotheses.hpp"

namespace parlour::adapters::nlu {

namespace {

// From this score on, grammars need no hypothesis.
constexpr double well_understood = 0.9;
// What a hypothesis needs in the place of a sentence, and how much better than
// a value it must be that is expected.
constexpr double likely = 0.6;
constexpr double much_better = 0.2;

// Whether the hypothesis has these values, too.
bool has_all(const BuiltAct& hypothesis, const BuiltAct& act) {
  return std::ranges::all_of(act.fills, [&](const Fill& fill) {
    return std::ranges::any_of(hypothesis.fills, [&](const Fill& other) {
      return other.begin <= fill.begin && fill.end <= other.end;
    });
  });
}

// Whether it has them as the same values, those aside that only a rule gives.
bool keeps_values(const BuiltAct& hypothesis, const BuiltAct& act) {
  return std::ranges::all_of(act.fills, [&](const Fill& fill) {
    return fill.literal ||
           std::ranges::any_of(hypothesis.fills, [&](const Fill& other) {
             return !other.literal && other.span == fill.span &&
                    other.begin == fill.begin && other.end == fill.end;
           });
  });
}

// Acts about the conversation for which a part of a sentence about a topic may
// be taken: "repeat the alarm". A yes or no is never replaced, nor who wants a
// person, nor courtesy.
bool is_replaceable(const BuiltAct& act) {
  static const WordSet kept{"confirm", "deny",  "correct", "person",
                            "thank",   "greet", "bye"};
  return act.topic == no_topic && act.score < well_understood &&
         !kept.contains(act.act);
}

// A bare value tells no topic by itself. If the conversation does not expect
// it, the words around it decide.
bool is_better(const BuiltAct& act, const BuiltAct& hypothesis,
               const Context& context, bool well_taught) {
  // What is broken off is what goes on: "never mind, I can walk".
  const bool breaks_off = act.act == "cancel" || act.act == "abandon";
  if (act.topic == no_topic)
    return is_replaceable(act) && hypothesis.score > act.score &&
           !(breaks_off && context.expects(hypothesis.topic));
  if (well_taught && act.topic == context.asked_topic)
    return false;
  const bool is_expected = context.expects(act.topic);
  const auto needed =
      act.score + (well_taught && is_expected ? much_better : 0);
  return act.elliptical && act.act != "correct" &&
         (needed < hypothesis.score ||
          (!is_expected && has_all(hypothesis, act)));
}

// A question that is answered wrongly costs less than a task that nobody wants,
// so none is begun instead of an answer.
bool is_better_sentence(const BuiltAct& act, const BuiltAct& hypothesis,
                        const Schema& schema, const Context& context) {
  return act.topic != no_topic && act.score < well_understood &&
         hypothesis.score > likely && context.asked_topic == no_topic &&
         !context.expects(act.topic) && keeps_values(hypothesis, act) &&
         (schema.at(hypothesis.topic).enquiry || !schema.at(act.topic).enquiry);
}

} // namespace

bool leaves_open(const std::vector<BuiltAct>& acts) {
  return acts.empty() ||
         (acts.size() == 1 &&
          (acts[0].topic == no_topic
               ? is_replaceable(acts[0])
               : acts[0].elliptical || acts[0].score < well_understood));
}

bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& hypothesis,
                   const Schema& schema, const Context& context,
                   bool well_taught) {
  const bool better =
      acts.empty() || is_better(acts[0], hypothesis, context, well_taught) ||
      (well_taught && acts.size() == 1 &&
       is_better_sentence(acts[0], hypothesis, schema, context));
  if (acts.empty() || (better && acts[0].topic != hypothesis.topic)) {
    acts = {hypothesis};
    return true;
  }
  if (acts[0].topic != hypothesis.topic || acts[0].act == "deny")
    return false;
  for (const auto& fill : hypothesis.fills)
    if (may_fill(acts[0].fills, fill,
                 schema.at(hypothesis.topic).takes_many(fill.slot)))
      acts[0].fills.push_back(fill);
  // Several topics take this value, but the whole sentence is about this one:
  // the act is no longer elliptical.
  const bool sentence = better && acts[0].act == hypothesis.act &&
                        context.bonus(hypothesis.topic) == 0;
  if (sentence) {
    acts[0].score = hypothesis.score;
    acts[0].elliptical = false;
  }
  return sentence;
}

} // namespace parlour::adapters::nlu
