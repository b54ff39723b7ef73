#include "adapters/nlu/parse/pronoun_one.hpp"

#include <array>
#include <string_view>

#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// Behind these, "one" is a number: "my room one".
bool is_numbered(std::string_view word) {
  static constexpr std::array<std::string_view, 20> words{
      "room", "number",  "level", "floor",    "table",    "ward",   "gate",
      "card", "channel", "line",  "block",    "unit",     "tower",  "option",
      "lift", "bus",     "bed",   "terminal", "platform", "counter"};
  return has(words, word);
}

} // namespace

bool is_pronoun_one(const Utterance& utterance, std::size_t position) {
  static constexpr std::array<std::string_view, 10> before{
      "this", "that", "which", "another", "other",
      "got",  "buy",  "new",   "any",     "the"};
  const auto& list = utterance.tokens.list;
  if (list[position].word != "one")
    return false;
  if (position + 1 < list.size() && list[position + 1].word == "of")
    return true;
  if (position == 0)
    return false;
  const auto& last = list[position - 1].word;
  return has(before, last) ||
         (position > 1 && list[position - 1].before == Break::none &&
          list[position].before == Break::none &&
          is_determiner(list[position - 2].word) &&
          !utterance.function[position - 1] && !is_numbered(last) &&
          !number_at(utterance.tokens, position - 1));
}

} // namespace parlour::adapters::nlu
