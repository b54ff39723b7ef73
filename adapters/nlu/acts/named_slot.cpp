#include "adapters/nlu/acts/named_slot.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "adapters/nlu/acts/choice.hpp"
#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

// Words around the name that tell no value.
bool is_carrier(std::string_view word) {
  static const WordSet words{"the", "my",     "a",    "an",   "that",  "it",
                             "is",  "was",    "no",   "nope", "to",    "can",
                             "you", "please", "just", "only", "sorry", "but",
                             "be",  "could",  "let",  "us",   "me"};
  return words.contains(word);
}

// Somebody wants something, which is to change the slot only beside a word that
// says so: not "I have no time".
bool wishes(std::string_view word) {
  static const WordSet words{"i",    "we",   "want", "would", "like",
                             "need", "have", "must", "should"};
  return words.contains(word);
}
bool mends(std::string_view word) {
  static const WordSet words{"change",  "fix",       "wrong", "incorrect",
                             "another", "different", "other", "new",
                             "not",     "mistake"};
  return words.contains(word);
}

// "The day is not right": of no other word it is said that it is.
bool is_right(std::string_view word) {
  return word == "right" || word == "correct";
}

// Where these words stand one behind the other; the end of the utterance: they
// do not.
std::size_t find(const Utterance& utterance,
                 const std::vector<std::string>& words) {
  const auto& list = utterance.tokens.list;
  const auto found =
      std::search(list.begin(), list.end(), words.begin(), words.end(),
                  [](const Token& token, const std::string& word) {
                    return token.word == word;
                  });
  return words.empty() ? list.size()
                       : static_cast<std::size_t>(found - list.begin());
}

} // namespace

std::optional<BuiltAct> named_slot_of(const Utterance& utterance,
                                      const Context& context) {
  const Context::NamedSlot* named = nullptr;
  std::size_t begin = 0;
  for (const auto& slot : context.changes) {
    const auto at = find(utterance, slot.words);
    if (at == utterance.size())
      continue;
    // "Phone number" is more than "number".
    if (named && named->words.size() == slot.words.size())
      return {};
    if (!named || slot.words.size() > named->words.size()) {
      named = &slot;
      begin = at;
    }
  }
  if (!named)
    return {};
  const auto end = begin + named->words.size();
  bool has_wish = false;
  bool has_mend = false;
  const auto& list = utterance.tokens.list;
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    if ((at >= begin && at < end) || utterance.filler[at])
      continue;
    const auto& word = list[at].word;
    if (is_right(word) && (at == 0 || list[at - 1].word != "not"))
      return {};
    has_wish = has_wish || wishes(word);
    has_mend = has_mend || mends(word);
    if (!is_carrier(word) && !wishes(word) && !mends(word) && !is_right(word))
      return {};
  }
  if (has_wish && !has_mend)
    return {};
  BuiltAct act;
  act.act = "correct";
  act.topic = context.changes_topic;
  act.end = static_cast<std::uint32_t>(utterance.size());
  act.score = 1;
  Fill name;
  name.slot = named->slot;
  name.topic = act.topic;
  name.begin = static_cast<std::uint32_t>(begin);
  name.end = static_cast<std::uint32_t>(end);
  name.is_name = true;
  act.fills.push_back(std::move(name));
  return act;
}

std::optional<BuiltAct> choice_or_named_slot(const Utterance& utterance,
                                             const Context& context) {
  auto choice = choice_of(utterance, context);
  return choice ? choice : named_slot_of(utterance, context);
}

} // namespace parlour::adapters::nlu
