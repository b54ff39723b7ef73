#include "adapters/nlu/understand/sentences_apart.hpp"

#include <algorithm>
#include <cstdint>

#include "adapters/nlu/text/word_set.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::uint32_t least_question = 3; // words
// How sure an act must be.
constexpr double surely_said = 0.6;
constexpr double certainly_said = 0.9;

// "Do not forget the towels" and "Will Smith is here" are none.
bool begins_question(std::string_view first, std::string_view second) {
  static const WordSet words{"is",    "are",    "am",    "does",
                             "did",   "can",    "could", "may",
                             "might", "should", "would", "shall"};
  static const WordSet verbs{"do", "will", "have", "must"};
  static const WordSet subjects{"i",  "you",   "we", "they", "he",  "she",
                                "it", "there", "my", "your", "the", "any"};
  return is_asking_word(first) || words.contains(first) ||
         (verbs.contains(first) && subjects.contains(second));
}

// What is heard has no question mark.
bool is_question(const Utterance& utterance, TokenRange sentence) {
  const auto& tokens = utterance.tokens.list;
  if (sentence.end - sentence.begin < least_question)
    return false;
  auto first = sentence.begin;
  while (first + 2 < sentence.end && utterance.filler[first])
    ++first;
  return begins_question(tokens[first].word, tokens[first + 1].word) ||
         utterance.text.substr(tokens[sentence.end - 1].end).starts_with('?');
}

} // namespace

std::vector<SentenceApart> sentences_apart(const Utterance& utterance,
                                           const std::vector<BuiltAct>& acts) {
  std::vector<SentenceApart> apart;
  const auto size = static_cast<std::uint32_t>(utterance.size());
  for (std::uint32_t begin = 0; begin < size;) {
    const auto sentence =
        stretch_of(utterance.tokens, {begin, begin + 1}, Break::sentence);
    begin = sentence.end;
    if (sentence.begin == 0 && sentence.end == size)
      return {};
    if (!utterance.has_content(sentence.begin, sentence.end))
      continue;
    SentenceApart one{words_of(utterance.text, utterance.tokens, sentence.begin,
                               sentence.end),
                      {},
                      is_question(utterance, sentence)};
    bool is_apart = true;
    for (std::size_t i = 0; i < acts.size(); ++i)
      if (acts[i].begin < sentence.end && sentence.begin < acts[i].end) {
        one.acts.push_back(i);
        is_apart = is_apart && sentence.begin <= acts[i].begin &&
                   acts[i].end <= sentence.end;
      }
    if (is_apart)
      apart.push_back(std::move(one));
  }
  return apart;
}

bool is_said_alone(const Value& act, const List& learnt) {
  const auto score = act[act_key::confidence].number_or(0);
  const auto& topic = act[act_key::topic];
  if (topic.is_unknown() || learnt.empty())
    return !topic.is_unknown() && score >= surely_said;
  const auto says = [](const Value& one) {
    const auto* slots = one[act_key::slots].if_map();
    return slots && !slots->empty();
  };
  return score >= certainly_said && !act[act_key::elliptical] && says(act) &&
         (topic != learnt.front()[act_key::topic] || !says(learnt.front()));
}

void put_before(List alone, List& learnt) {
  for (auto& act : learnt)
    if (std::ranges::none_of(alone, [&](const Value& other) {
          return other[act_key::topic] == act[act_key::topic];
        }))
      alone.push_back(std::move(act));
  learnt = std::move(alone);
}

} // namespace parlour::adapters::nlu
