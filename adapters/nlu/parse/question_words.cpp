#include "adapters/nlu/parse/question_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "adapters/nlu/forms/number_words.hpp"

namespace parlour::adapters::nlu {

namespace {

bool stands_for_it(std::string_view word) {
  static constexpr std::array<std::string_view, 5> words{"it", "that", "this",
                                                         "them", "those"};
  return std::ranges::find(words, word) != words.end();
}

} // namespace

bool QuestionWords::has(std::size_t token) const {
  return std::ranges::find(context_.confirms,
                           utterance_.tokens.list[token].word) !=
             context_.confirms.end() ||
         has_number(token) || has_synonym(token);
}

bool QuestionWords::has_number(std::size_t token) const {
  const auto number = number_at(utterance_.tokens, token);
  return number &&
         std::ranges::any_of(context_.confirms, [&](const auto& asked) {
           const auto digits =
               std::min(asked.find_first_not_of("0123456789"), asked.size());
           return digits_of(asked.substr(0, digits)) == number->value;
         });
}

bool QuestionWords::has_synonym(std::size_t token) const {
  const auto* synonyms = utterance_.synonyms[token];
  return synonyms && utterance_.automaton &&
         std::ranges::any_of(context_.confirms, [&](const auto& asked) {
           const auto word = utterance_.automaton->word(asked);
           return word != unknown_word &&
                  std::ranges::find(*synonyms, word) != synonyms->end();
         });
}

// "Get rid of it" is to cancel, whatever its words are. "Leave it" may mean
// that things stay as they are.
bool QuestionWords::is_named(const BuiltAct& act) const {
  const auto word = [&](std::uint32_t token) -> const std::string& {
    return utterance_.tokens.list[token].word;
  };
  return act.topic == no_topic && stands_for_it(word(act.end - 1)) &&
         word(act.begin) != "leave" &&
         std::ranges::find(context_.confirms, act.act) !=
             context_.confirms.end();
}

bool QuestionWords::has_all_of(const BuiltAct& act) const {
  const bool has_value = std::ranges::any_of(
      act.fills, [](const Fill& fill) { return !fill.literal; });
  if (has_value || act.negated)
    return false;
  if (is_named(act))
    return true;
  std::size_t meant = 0;
  for (auto token = act.begin; token < act.end; ++token) {
    if (utterance_.weight[token] < full_weight ||
        stands_for_it(utterance_.tokens.list[token].word))
      continue;
    if (!has(token))
      return false;
    ++meant;
  }
  return meant == 1;
}

} // namespace parlour::adapters::nlu
