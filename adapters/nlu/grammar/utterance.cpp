// Classifies the words of an utterance. An unknown word weighs as much as a
// known one, so that words which were not understood lower the score.
#include "adapters/nlu/grammar/utterance.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "adapters/nlu/forms/calendar.hpp"
#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/negation.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

using Phrase = std::vector<std::string>;

Phrase phrase_of(std::string_view text) {
  Phrase words;
  for (auto& token : tokenize(text).list)
    words.push_back(std::move(token.word));
  return words;
}

// The filler phrases by their first word, so that each token needs one look-up.
const TextMap<std::vector<Phrase>>& phrases() {
  static const auto table = [] {
    TextMap<std::vector<Phrase>> made;
    for (const auto phrase : filler_phrases()) {
      auto words = phrase_of(phrase);
      made[words[0]].push_back(std::move(words));
    }
    return made;
  }();
  return table;
}

// Whether the phrase stands at this position.
bool stands_at(const Phrase& phrase, const std::vector<Token>& list,
               std::size_t position) {
  if (position + phrase.size() > list.size())
    return false;
  for (std::size_t at = 0; at < phrase.size(); ++at)
    if (list[position + at].word != phrase[at])
      return false;
  return true;
}

bool is_capital(char letter) {
  return letter >= 'A' && letter <= 'Z';
}

// "the ER", where the application has such a word: in capital letters, or
// right behind a determiner. In "er, where is the bank" it means nothing.
bool is_own_word(const std::vector<Token>& list, std::size_t at,
                 std::string_view text, const Automaton& automaton) {
  const auto& token = list[at];
  if (!automaton.own_hesitations.contains(token.word))
    return false;
  const auto written = text.substr(token.begin, token.end - token.begin);
  return std::ranges::all_of(written, is_capital) ||
         (at > 0 && token.before == Break::none &&
          is_determiner(list[at - 1].word));
}

// How many words behind "where" are only cross: "where the devil", "what on
// earth".
std::size_t cross_words(const std::vector<Token>& list, std::size_t at) {
  static const std::vector<Phrase> all{
      {"the", "hell"},    {"the", "heck"}, {"the", "devil"},
      {"the", "dickens"}, {"on", "earth"}, {"in", "the", "world"}};
  for (const auto& words : all)
    if (stands_at(words, list, at))
      return words.size();
  return 0;
}

void mark_fillers(Utterance& utterance) {
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    if (at > 0 && is_asking_word(utterance.tokens.list[at - 1].word))
      std::fill_n(utterance.filler.begin() + static_cast<std::ptrdiff_t>(at),
                  cross_words(utterance.tokens.list, at), true);
    const auto found = phrases().find(utterance.tokens.list[at].word);
    if (found == phrases().end())
      continue;
    for (const auto& phrase : found->second)
      if (stands_at(phrase, utterance.tokens.list, at))
        for (std::size_t word = 0; word < phrase.size(); ++word)
          utterance.filler[at + word] = true;
    if (is_own_word(utterance.tokens.list, at, utterance.text,
                    *utterance.automaton))
      utterance.filler[at] = false;
  }
}

// -- noise within what is said ------------------------------------------------

// "mm hm" and "uh huh" say yes, and each of their sounds alone means nothing.
bool says_yes(const std::vector<Token>& list, std::size_t at) {
  if (at + 1 >= list.size())
    return false;
  const auto& second = list[at + 1].word;
  return (list[at].word == "mm" || list[at].word == "uh") &&
         (second == "hm" || second == "hmm" || second == "huh");
}

// "ah" and "eh" are names, too, so they count as noise only beside numbers,
// days and hours: "two ah o'clock".
bool is_noise(const std::vector<Token>& list, std::size_t at,
              std::string_view text, const Automaton& automaton) {
  const auto& word = list[at].word;
  const auto* next = at + 1 < list.size() ? &list[at + 1].word : nullptr;
  if (is_own_word(list, at, text, automaton))
    return false;
  if (is_hesitation(word))
    return !says_yes(list, at) && !(at > 0 && says_yes(list, at - 1));
  return word == "ah" && at > 0 && next &&
         (is_number_word(list[at - 1].word) || is_number_word(*next) ||
          weekday_of(*next) || month_of(*next) != 0);
}

// What people say to win time in the middle of a sentence.
const std::vector<Phrase>& pauses() {
  static const std::vector<Phrase> all{
      phrase_of("let me think"),        phrase_of("let me see"),
      phrase_of("let me check"),        phrase_of("how do you say"),
      phrase_of("how do you call it"),  phrase_of("how shall i put it"),
      phrase_of("what do you call it"), phrase_of("what is it called"),
      phrase_of("what was it"),         phrase_of("what was it called"),
      phrase_of("what is the name"),    phrase_of("what was the name")};
  return all;
}

bool goes_on(std::string_view word) {
  static constexpr std::array<std::string_view, 12> words{
      "to",  "from", "with", "is",    "are",  "am",
      "was", "see",  "meet", "about", "need", "want"};
  return is_light(word) || has(words, word);
}

// How many words of such a pause stand between commas: "I am here for, let me
// think, Dr. Ho". 0: none. "Yes, let me think, er" asks for time.
std::size_t pause_at(const std::vector<Token>& list, std::size_t at) {
  if (at == 0 || list[at].before != Break::comma)
    return 0;
  for (const auto& pause : pauses()) {
    const auto end = at + pause.size();
    if (stands_at(pause, list, at) && end < list.size() &&
        list[end].before == Break::comma)
      return pause[0] != "let" || goes_on(list[at - 1].word) ? pause.size() : 0;
  }
  return 0;
}

// Whether the `count` words from `at` are said again right behind.
bool is_said_again(const std::vector<Token>& list, std::size_t at,
                   std::size_t count) {
  if (at + 2 * count > list.size())
    return false;
  for (std::size_t word = at; word < at + count; ++word)
    if (list[word].word != list[word + count].word ||
        list[word].word.size() < 2 || is_number_word(list[word].word) ||
        list[word + count].before == Break::sentence)
      return false;
  return true;
}

// One word alone may be a name ("Ting Ting"), if no grammar has it.
bool is_restart(const std::vector<Token>& list, std::size_t at,
                std::size_t count, const Automaton& automaton) {
  if (!is_said_again(list, at, count))
    return false;
  const auto& word = list[at].word;
  return count > 1 || list[at + 1].before == Break::comma ||
         is_function_word(word) || automaton.word(word) != unknown_word;
}

// Quickly, whether there may be any noise: a hesitation, a pause, or a word
// that comes again soon.
bool has_noise(const std::vector<Token>& list, std::string_view text,
               const Automaton& automaton) {
  for (std::size_t at = 0; at < list.size(); ++at) {
    if (is_noise(list, at, text, automaton) || pause_at(list, at) > 0)
      return true;
    for (std::size_t ahead = 1; ahead <= 3 && at + ahead < list.size(); ++ahead)
      if (list[at].word == list[at + ahead].word)
        return true;
  }
  return false;
}

// How many words of a restart are looked at: "the food, the food court".
constexpr std::size_t longest_restart = 3;

// Removes hesitations and what is said twice, so that values and rules are
// found that they interrupt. What consists of nothing else stays.
void remove_noise(Tokens& tokens, std::string_view text,
                  const Automaton& automaton) {
  auto& list = tokens.list;
  std::vector<Token> kept;
  // Punctuation before a hesitation stands before what follows it.
  auto before = Break::none;
  for (std::size_t at = 0; at < list.size(); ++at) {
    before = std::max(before, list[at].before);
    if (const auto pause = pause_at(list, at); pause > 0) {
      at += pause - 1;
      continue;
    }
    if (is_noise(list, at, text, automaton))
      continue;
    kept.push_back(list[at]);
    kept.back().before = std::exchange(before, Break::none);
  }
  if (kept.empty())
    return;
  list = std::exchange(kept, {});
  for (std::size_t at = 0; at < list.size();) {
    std::size_t skipped = 0;
    for (auto count = longest_restart; count > 0 && skipped == 0; --count)
      skipped = is_restart(list, at, count, automaton) ? count : 0;
    if (skipped == 0)
      kept.push_back(list[at++]);
    at += skipped;
  }
  if (kept.size() < list.size())
    list = std::move(kept);
}

bool begins_number(std::string_view word) {
  return is_number_word(word) || word == "half" || word == "quarter" ||
         (!word.empty() && word[0] >= '0' && word[0] <= '9');
}

// Whether nothing but a number stands there up to the end of the clause: "no,
// one moment" mends nothing.
bool is_all_number(const std::vector<Token>& list, std::size_t at) {
  static constexpr std::array<std::string_view, 6> words{
      "past", "to", "oclock", "am", "pm", "please"};
  const auto begin = at;
  for (; at < list.size() && (at == begin || list[at].before == Break::none);
       ++at)
    if (!begins_number(list[at].word) && !has(words, list[at].word))
      return false;
  return at > begin && list[begin].before != Break::sentence &&
         begins_number(list[begin].word);
}

// "No, wait, make it four"
bool leads_to_mended(std::string_view word) {
  static constexpr std::array<std::string_view, 10> words{
      "wait", "sorry", "i", "mean", "make", "it", "that", "rather", "at", "a"};
  return has(words, word);
}

// "At four. No, half past four, to Orchard Road": a number that is mended at
// once is mended within the sentence, whatever stands between.
void join_mended_numbers(std::vector<Token>& list) {
  for (std::size_t at = 1; at + 1 < list.size(); ++at) {
    if (list[at].word != "no" || list[at].before != Break::sentence ||
        !begins_number(list[at - 1].word))
      continue;
    auto next = at + 1;
    while (next + 1 < list.size() && next < at + 4 &&
           list[next].before != Break::sentence &&
           leads_to_mended(list[next].word))
      ++next;
    if (is_all_number(list, next))
      list[at].before = Break::comma;
  }
}

} // namespace

bool Utterance::has_content(std::size_t first, std::size_t last) const {
  for (auto at = first; at < last && at < weight.size(); ++at)
    if (weight[at] >= full_weight)
      return true;
  return false;
}

double Utterance::weight_of(std::size_t first, std::size_t last) const {
  double sum = 0;
  for (auto at = first; at < last && at < weight.size(); ++at)
    sum += weight[at];
  return sum;
}

// Goes back from `begin` to the negation. A comma or full stop ends the search.
bool Utterance::is_negated(std::size_t begin) const {
  for (auto at = begin; at > 0; --at) {
    if (tokens.list[at].before != Break::none)
      return false;
    if (negates[at - 1])
      return true;
    if (!filler[at - 1] && !is_linking_word(tokens.list[at - 1].word))
      return false;
  }
  return false;
}

Utterance make_utterance(std::string_view text, const Automaton& automaton) {
  Utterance made;
  made.text = text;
  made.automaton = &automaton;
  made.tokens = tokenize(text);
  if (has_noise(made.tokens.list, text, automaton))
    remove_noise(made.tokens, text, automaton);
  join_mended_numbers(made.tokens.list);
  const auto size = made.size();
  made.filler.resize(size);
  mark_fillers(made);
  made.negates = negations(made.tokens);
  for (std::size_t at = 0; at < size; ++at) {
    const auto& word = made.tokens.list[at].word;
    made.words.push_back(automaton.word(word));
    made.synonyms.push_back(automaton.synonyms_of(word));
    made.function.push_back(is_function_word(word));
    // A word that a grammar uses is not part of a name that is unknown.
    made.plain.push_back(made.filler[at] || made.function[at] ||
                         is_title(word) || made.words[at] != unknown_word);
    made.weight.push_back(made.filler[at]     ? 0.0F
                          : made.function[at] ? 0.5F
                                              : 1.0F);
  }
  return made;
}

} // namespace parlour::adapters::nlu
