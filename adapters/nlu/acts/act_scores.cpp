#include "adapters/nlu/acts/act_scores.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "adapters/nlu/acts/courtesies.hpp"
#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/parse/question_words.hpp"
#include "adapters/nlu/text/has.hpp"

namespace parlour::adapters::nlu {

namespace {

// The least that is understood of what has a value in a clause of its own.
constexpr double clause_of_value = 0.5;
// "20805" is what somebody or something is known by.
constexpr std::size_t digits_of_a_name = 4;
// Words that may follow a value in its sentence: ", as always".
constexpr std::uint32_t most_behind_value = 2;

// How much of each token is understood, from 0 to its weight. An island's
// coverage is spread evenly over its tokens.
std::vector<double> coverage(const Chain& chain, std::size_t size) {
  std::vector<double> covered(size, 0);
  for (const auto& link : chain.links) {
    const auto& island = *link.island;
    const auto length = double(island.end - island.begin);
    for (auto at = island.begin; at < island.end; ++at)
      covered[at] = island.covered / length;
  }
  return covered;
}

double bonus_of(const BuiltAct& act, const Context& context) {
  if (act.topic == no_topic)
    return 0;
  const auto fills = [&](std::string_view slot) {
    return std::ranges::find(act.fills, slot, &Fill::slot) != act.fills.end();
  };
  const bool asked =
      act.topic == context.asked_topic && fills(context.asked_slot);
  return context.bonus(act.topic) + (asked ? asked_bonus : 0) +
         context.waiting_bonus(act.topic, fills(context.waiting_slot));
}

// What a yes says in words of the question: "yes, give it up".
double repeated(const BuiltAct& act, const std::vector<double>& covered,
                const Utterance& utterance, const Context& context,
                TokenRange range) {
  if (act.topic != no_topic || act.act != "confirm")
    return 0;
  const QuestionWords question(utterance, context);
  double sum = 0;
  for (auto token = range.begin; token < range.end; ++token)
    if (covered[token] == 0 && question.has(token))
      sum += utterance.weight[token];
  return sum;
}

// Whether the clause from here on says that something is or was: "the sun has
// come out".
bool has_verb(const Utterance& utterance, std::size_t at) {
  const auto first = static_cast<std::uint32_t>(at);
  const auto end =
      stretch_of(utterance.tokens, {first, first + 1}, Break::comma).end;
  for (; at < end; ++at)
    if (is_one_of(utterance.tokens.list[at].word,
                  {"is", "are", "was", "were", "has", "have", "had", "does",
                   "do", "did", "will", "would", "can"}))
      return true;
  return false;
}

// A clause that tells why: "he is busy", "my son is here", "it is only rain".
// What "it is the blue one" tells is no reason.
// "The sun has come out" is one for who calls something off; to a question,
// "the blue room will do" is an answer.
bool tells_why(const Utterance& utterance, std::size_t at, bool calls_off) {
  const auto word = [&](std::size_t token) -> std::string_view {
    if (token >= utterance.size())
      return {};
    return utterance.tokens.list[token].word;
  };
  while (at < utterance.size() && utterance.filler[at])
    ++at;
  if (is_one_of(word(at), {"it", "that", "this"}))
    return word(at + 1) == "is" &&
           is_one_of(word(at + 2), {"only", "just", "too", "already", "not"});
  if (word(at) == "the")
    return calls_off && has_verb(utterance, at);
  return is_one_of(word(at), {"i", "we", "he", "she", "they", "my", "our",
                              "his", "her", "their", "somebody", "someone",
                              "nobody", "there", "because", "since"});
}

// "No, don't, he is busy": whoever refuses or gives up in a clause of its own
// may say why, in words that no rule knows. A yes has no such right.
bool is_reasoned(const BuiltAct& act, const std::vector<double>& covered,
                 const Utterance& utterance) {
  if (act.topic != no_topic || !is_one_of(act.act, {"deny", "cancel"}) ||
      utterance.weight_of(0, act.begin) > 0 || act.end >= utterance.size() ||
      utterance.tokens.list[act.end].before == Break::none ||
      !tells_why(utterance, act.end, act.act == "cancel"))
    return false;
  for (auto token = act.end; token < utterance.size(); ++token)
    if (covered[token] > 0 && utterance.weight[token] >= full_weight)
      return false;
  return true;
}

// "Wow, long name. Which floor?": nothing is left of its sentence. A mere value
// is none, and of what is about the conversation only a yes that is asked for
// and comes first: "Yes please. My brother waits."
bool is_whole_sentence(const BuiltAct& act, const std::vector<double>& covered,
                       const Utterance& utterance, const Context& context) {
  const bool answers = act.act == "confirm" && !context.confirms.empty() &&
                       utterance.weight_of(0, act.begin) == 0;
  if ((act.topic == no_topic && !answers) || act.is_aside)
    return false;
  const auto sentence =
      stretch_of(utterance.tokens, {act.begin, act.end}, Break::sentence);
  for (auto token = sentence.begin; token < sentence.end; ++token)
    if (covered[token] == 0 && utterance.weight[token] > 0)
      return false;
  return true;
}

// A mere value that is all of a sentence, or of a clause that corrects: "The
// blue one, as always. I got it from …", "oh these figures, I mean 20805". A
// small number, or words that may be anything, are none.
bool is_clause_of_value(const BuiltAct& act, const std::vector<double>& covered,
                        const Utterance& utterance) {
  const auto clause =
      stretch_of(utterance.tokens, {act.begin, act.end}, Break::comma);
  for (auto token = clause.begin; token < clause.end; ++token)
    if (covered[token] == 0 && utterance.weight[token] > 0)
      return false;
  const auto sentence =
      stretch_of(utterance.tokens, {act.begin, act.end}, Break::sentence);
  if (act.act != "correct" &&
      (utterance.has_content(sentence.begin, clause.begin) ||
       sentence.end - clause.end > most_behind_value))
    return false;
  return std::ranges::any_of(act.fills, [&](const Fill& fill) {
    if (fill.literal || fill.open)
      return false;
    const auto& word = utterance.tokens.list[fill.begin].word;
    return (has_digit(word) ? digits_of(word) && word.size() >= digits_of_a_name
                            : utterance.has_content(fill.begin, fill.end) &&
                                  !is_number_word(word));
  });
}

} // namespace

// An act is scored on the tokens from its begin to the begin of the next one,
// a refusal without its reason, all without the courtesies around them; one
// that a rule declares, within its clauses, one that is a whole sentence within
// that: "What a big house. Where do I find Kelvin Ho?" asks a clear question. A
// mere value among much that is not understood says little, whatever clause it
// is in.
void set_scores(std::vector<BuiltAct>& acts, const Chain& chain,
                const Utterance& utterance, const Context& context) {
  const auto covered = coverage(chain, utterance.size());
  const auto polite = courtesy_tokens(chain, utterance, context);
  for (std::size_t at = 0; at < acts.size(); ++at) {
    const auto& act = acts[at];
    std::size_t first = at == 0 ? 0 : act.begin;
    std::size_t last =
        at + 1 < acts.size() ? acts[at + 1].begin : utterance.size();
    if (is_reasoned(act, covered, utterance))
      last = act.end;
    const bool is_whole = is_whole_sentence(act, covered, utterance, context);
    if (act.is_declared || is_whole) {
      const auto own = stretch_of(utterance.tokens, {act.begin, act.end},
                                  is_whole ? Break::sentence : Break::comma);
      first = std::max<std::size_t>(first, own.begin);
      last = std::min<std::size_t>(last, own.end);
    }
    auto sum = repeated(
        act, covered, utterance, context,
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)});
    double whole = 0;
    const auto is_its_own = [&](std::size_t token) {
      return act.topic == no_topic && act.begin <= token && token < act.end;
    };
    for (auto token = first; token < last; ++token)
      if (!polite[token] || is_its_own(token)) {
        sum += covered[token];
        whole += utterance.weight[token];
      }
    acts[at].understood = whole > 0 ? std::min(1.0, sum / whole) : 1.0;
    if (acts.size() == 1 && is_clause_of_value(act, covered, utterance))
      acts[at].understood = std::max(acts[at].understood, clause_of_value);
    acts[at].score = acts[at].understood + bonus_of(acts[at], context);
  }
}

} // namespace parlour::adapters::nlu
