#include "adapters/nlu/understand/better_reading.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "adapters/nlu/acts/courtesies.hpp"
#include "adapters/nlu/parse/open_words.hpp"
#include "adapters/nlu/parse/unmatched_values.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/word_set.hpp"
#include "adapters/nlu/understand/hypotheses.hpp"

namespace parlour::adapters::nlu {

namespace {

// From this score on, grammars need no hypothesis.
constexpr double well_understood = 0.9;
// The same where only small words are left over: "I am in the kitchen now".
constexpr double understood_but_small_words = 0.8;
// So much, and it may have been another wish.
constexpr double hardly_understood = 0.55;
// What a hypothesis needs in the place of a sentence …
constexpr double likely = 0.6;
// … if it takes away what may be a value, means something else of the same
// topic, or a question waits …
constexpr double very_likely = 0.85;
// … and how much better than a value it must be that is expected.
constexpr double much_better = 0.3;

// Whether the hypothesis has these values, too.
bool has_all(const BuiltAct& hypothesis, const BuiltAct& act) {
  return std::ranges::all_of(act.fills, [&](const Fill& fill) {
    return std::ranges::any_of(hypothesis.fills, [&](const Fill& other) {
      return other.begin <= fill.begin && fill.end <= other.end;
    });
  });
}

// Whether it gives a slot of which the act says nothing by itself, or something
// else in the place of all that the act says by itself.
bool says_other(const BuiltAct& hypothesis, const BuiltAct& act) {
  const bool has_values = std::ranges::any_of(
      act.fills, [](const Fill& fill) { return !fill.literal; });
  return std::ranges::any_of(hypothesis.fills, [&](const Fill& fill) {
    return fill.literal &&
           std::ranges::none_of(act.fills, [&](const Fill& other) {
             return other.slot == fill.slot && other.literal &&
                    (has_values || other.literal == fill.literal);
           });
  });
}

// Acts about the conversation for which a part of a sentence about a topic may
// be taken: "repeat the alarm". A yes or no is never replaced, nor who wants a
// person; courtesy only where it opens what is said.
bool is_replaceable(const BuiltAct& act) {
  static const WordSet kept{"confirm", "deny",  "correct", "person",
                            "thank",   "greet", "bye"};
  return act.topic == no_topic && act.score < well_understood &&
         !kept.contains(act.act);
}

} // namespace

bool BetterReading::are_openings(const std::vector<BuiltAct>& acts) const {
  return std::ranges::all_of(acts, [&](const BuiltAct& act) {
    return act.topic == no_topic && act.score < well_understood &&
           is_opening(act.act, act.begin, utterance_, context_);
  });
}

// "I see. I don't think I'll do that. Can my suitcases stay somewhere?"
bool BetterReading::are_weak_courtesies(
    const std::vector<BuiltAct>& acts) const {
  return well_taught_ && std::ranges::all_of(acts, [](const BuiltAct& act) {
           return act.topic == no_topic && act.score < well_understood &&
                  is_courtesy(act.act);
         });
}

// "Cancel my table for Monday": what is said behind it, in the same breath, is
// what is not wanted any more. "Cancel that and make it Monday" is complete.
bool BetterReading::name_what_ends(const std::vector<BuiltAct>& acts) const {
  static constexpr std::array<std::string_view, 6> pronouns{
      "it", "that", "this", "them", "everything", "all"};
  const auto& tokens = utterance_.tokens.list;
  return acts.size() > 1 && acts[0].act == "cancel" &&
         acts[0].topic == no_topic && acts[0].end < tokens.size() &&
         !has(pronouns, tokens[acts[0].end - 1].word) &&
         std::none_of(
             tokens.begin() + acts[0].end, tokens.end(),
             [](const Token& token) { return token.before != Break::none; });
}

bool BetterReading::leaves_open(const std::vector<BuiltAct>& acts) const {
  return are_openings(acts) || are_weak_courtesies(acts) ||
         name_what_ends(acts) ||
         (acts.size() == 1 &&
          (acts[0].topic == no_topic
               ? is_replaceable(acts[0])
               : acts[0].elliptical || leaves_words(acts[0])));
}

// "And Macbeth, when does that come back?": the act leaves a word that asks.
bool BetterReading::leaves_question(const BuiltAct& act) const {
  static constexpr std::array<std::string_view, 6> words{
      "where", "when", "who", "whom", "why", "how"};
  for (std::uint32_t token = 0; token < utterance_.size(); ++token)
    if ((token < act.begin || token >= act.end) && !utterance_.filler[token] &&
        has(words, utterance_.tokens.list[token].word))
      return true;
  return false;
}

bool BetterReading::leaves_words(const BuiltAct& act) const {
  const auto least =
      leaves_content(act) ? well_understood : understood_but_small_words;
  return act.score < least || leaves_question(act) || knows_no_value(act);
}

// "Where do I bring the van in?": the words stand for a value that there is
// not.
bool BetterReading::knows_no_value(const BuiltAct& act) const {
  return std::ranges::any_of(
      act.fills, [&](const Fill& fill) { return is_unmatched(fill, spans_); });
}

// Beside its own words.
bool BetterReading::leaves_content(const BuiltAct& act) const {
  return utterance_.has_content(0, act.begin) ||
         utterance_.has_content(act.end, utterance_.size());
}

// A bare value tells no topic by itself. If the conversation does not expect
// it, the words around it decide.
bool BetterReading::is_better(const BuiltAct& act,
                              const BuiltAct& hypothesis) const {
  // What is broken off is what goes on: "never mind, I can walk".
  const bool breaks_off = act.act == "cancel" || act.act == "abandon";
  if (act.topic == no_topic)
    return is_replaceable(act) && hypothesis.score > act.score &&
           std::ranges::all_of(
               act.fills,
               [&](const Fill& fill) { return keeps(hypothesis, fill); }) &&
           !(breaks_off && context_.expects(hypothesis.topic));
  if (well_taught_ && act.topic == context_.asked_topic)
    return false;
  if (!act.elliptical)
    return false;
  // Nor does it correct what nobody asks for: "but the pool's free, isn't it?".
  if (act.act == "correct")
    return well_taught_ && context_.asked_topic == no_topic &&
           knows_no_value(act) && hypothesis.score > likely;
  const bool is_expected = context_.expects(act.topic);
  const auto needed =
      act.score + (well_taught_ && is_expected ? much_better : 0);
  return needed < hypothesis.score ||
         (!is_expected && has_all(hypothesis, act));
}

// Words that may be a value by chance: in "how long may I hang on to a book",
// nobody wants a book with that word in its title.
bool BetterReading::is_doubtful(const Fill& fill) const {
  if (is_open(fill, spans_))
    return true;
  const auto& span = spans_[*fill.span];
  return span.unmatched || span.confidence < guessed_value ||
         span.values.size() > 1;
}

// Determiners before it aside.
bool BetterReading::is_same_value(const Fill& one, const Fill& other) const {
  if (one.literal || other.literal)
    return false;
  if (!one.span || !other.span)
    return one.span == other.span && one.begin == other.begin &&
           one.end == other.end;
  const auto& left = spans_[*one.span];
  const auto& right = spans_[*other.span];
  return left.entity == right.entity && left.core == right.core &&
         left.end == right.end;
}

// "My glasses", where all that is like it is said of the reading glasses.
bool BetterReading::is_meant_by(const Fill& literal, const Fill& said) const {
  if (!literal.literal || !said.span || literal.slot != said.slot)
    return false;
  const auto& span = spans_[*said.span];
  return is_set(span.entity) && span.values.size() == 1 &&
         schema_.values().value(span.entity - first_set_entity,
                                span.values[0]) == *literal.literal;
}

// Whether the hypothesis has the value, too, or only a rule gives it.
bool BetterReading::keeps(const BuiltAct& hypothesis, const Fill& fill) const {
  return fill.literal ||
         std::ranges::any_of(hypothesis.fills, [&](const Fill& other) {
           return is_same_value(fill, other) || is_meant_by(other, fill);
         });
}

// What the hypothesis must reach in the place of the act; nothing: it would
// lose a value that was surely said.
std::optional<double>
BetterReading::needed_instead_of(const BuiltAct& act,
                                 const BuiltAct& hypothesis) const {
  double needed = context_.expects(act.topic)        ? well_understood
                  : context_.asked_topic == no_topic ? likely
                                                     : very_likely;
  for (const auto& fill : act.fills) {
    if (keeps(hypothesis, fill))
      continue;
    if (!is_doubtful(fill))
      return {};
    needed = std::max(needed, very_likely);
  }
  return needed;
}

// A question that is answered wrongly costs less than a task that nobody wants,
// so none is begun instead of an answer, unless of that little was understood.
bool BetterReading::is_better_sentence(const BuiltAct& act,
                                       const BuiltAct& hypothesis) const {
  if (act.topic == no_topic || hypothesis.topic == no_topic ||
      !leaves_words(act) || context_.goes_on(act.topic))
    return false;
  const bool begins_task =
      !schema_.at(hypothesis.topic).enquiry && schema_.at(act.topic).enquiry;
  if (begins_task &&
      (act.score > hardly_understood || hypothesis.score < well_understood))
    return false;
  const auto needed = needed_instead_of(act, hypothesis);
  return needed && hypothesis.score > *needed;
}

// Beside what rules found, words are a value only if they look like one: not
// "a garden where I can breathe", "it's the big", nor "Jurong now".
bool BetterReading::is_clear(const Fill& fill) const {
  if (fill.span)
    return !is_vague(spans_[*fill.span], schema_);
  if (fill.literal)
    return true;
  const TokenRange value{fill.begin, fill.end};
  return !utterance_.function[fill.end - 1] &&
         certainty_of_words(utterance_, {value, value, false}) >= 1;
}

bool BetterReading::choose(std::vector<BuiltAct>& acts,
                           const BuiltAct& hypothesis) const {
  const bool opens = are_openings(acts) || (are_weak_courtesies(acts) &&
                                            hypothesis.score > very_likely);
  if (hypothesis.act == "cancel" && hypothesis.score > likely &&
      name_what_ends(acts)) {
    acts = {hypothesis};
    return true;
  }
  if (!opens && acts.size() > 1)
    return false;
  const bool is_sentence =
      !opens && well_taught_ && is_better_sentence(acts[0], hypothesis);
  const bool better = opens || is_sentence || is_better(acts[0], hypothesis);
  const bool means_other = opens || acts[0].topic != hypothesis.topic ||
                           hypothesis.act == "cancel" ||
                           (is_sentence && hypothesis.score > very_likely &&
                            says_other(hypothesis, acts[0]));
  if (better && means_other) {
    acts = {hypothesis};
    return true;
  }
  if (acts[0].topic != hypothesis.topic || acts[0].act == "deny")
    return false;
  for (const auto& fill : hypothesis.fills)
    if (is_clear(fill) &&
        may_fill(acts[0].fills, fill,
                 schema_.at(hypothesis.topic).takes_many(fill.slot)))
      acts[0].fills.push_back(fill);
  // Several topics take this value, but the whole sentence is about this one:
  // the act is no longer elliptical.
  const bool sentence = better && acts[0].act == hypothesis.act &&
                        context_.bonus(hypothesis.topic) == 0;
  if (sentence) {
    acts[0].score = hypothesis.score;
    acts[0].elliptical = false;
  }
  return sentence;
}

} // namespace parlour::adapters::nlu
