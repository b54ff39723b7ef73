#include "adapters/nlu/acts/choice.hpp"

#include <algorithm>
#include <string_view>

#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

using Words = WordSet;
// A bit for each choice. Of more, nobody says which by its place.
using Choices = std::uint32_t;
constexpr std::size_t max_choices = 16;

// Words around a choice that do not tell which one it is.
bool is_carrier(std::string_view word) {
  static const Words words{
      "the",    "one",   "ones",  "number", "option", "please", "i",
      "mean",   "meant", "would", "like",   "want",   "take",   "will",
      "have",   "it",    "is",    "that",   "give",   "me",     "to",
      "of",     "them",  "say",   "let",    "us",     "choose", "go",
      "for",    "yes",   "then",  "think",  "with",   "a",      "an",
      "you",    "said",  "free",  "be",     "just",   "need",   "in",
      "thanks", "sir",   "ok",    "named",  "called"};
  return words.contains(word);
}

bool is_all(std::string_view word) {
  static const Words words{"either", "any", "whichever", "whatever"};
  return words.contains(word);
}

bool is_none(std::string_view word) {
  return word == "neither" || word == "none";
}

class Chooser {
public:
  explicit Chooser(const std::vector<std::string>& choices)
      : size_(choices.size()) {
    for (std::size_t at = 0; at < size_; ++at) {
      words_.emplace_back();
      for (auto& token : tokenize(choices[at]).list)
        words_.back().push_back(std::move(token.word));
    }
    left_ = all();
  }

  // Takes the words one by one; false if one of them has to do with no choice.
  bool take(const Utterance& utterance) {
    for (std::size_t at = 0; at < utterance.size(); ++at)
      if (!utterance.filler[at] && !take(utterance, at))
        return false;
    return told_;
  }

  bool refused() const {
    return refused_;
  }
  // The choice that is left, or any of them if all are as good.
  std::optional<std::size_t> chosen() const {
    for (std::size_t at = 0; at < size_; ++at)
      if (left_ == bit(at) || (any_ && (left_ & bit(at)) != 0))
        return at;
    return {};
  }

private:
  static Choices bit(std::size_t at) {
    return Choices(1) << at;
  }
  Choices all() const {
    return bit(size_) - 1;
  }

  bool take(const Utterance& utterance, std::size_t at) {
    const auto& word = utterance.tokens.list[at].word;
    if (const auto named = those_with(word); named != 0)
      return keep(named);
    if (const auto place = place_of(utterance.tokens, at))
      return keep(*place < size_ ? bit(*place) : 0);
    if (is_all(word))
      return any_ = told_ = true;
    if (is_none(word))
      return refused_ = told_ = true;
    if (word.size() == 1 && is_spelt(utterance.tokens.list, at))
      return keep(those_with_letter(word[0]));
    return is_carrier(word);
  }

  // "with K", "with a K": other single letters are words.
  static bool is_spelt(const std::vector<Token>& tokens, std::size_t at) {
    if (at > 1 && (tokens[at - 1].word == "a" || tokens[at - 1].word == "an"))
      --at;
    return at > 0 && tokens[at - 1].word == "with";
  }

  std::optional<std::size_t> place_of(const Tokens& tokens,
                                      std::size_t at) const {
    const auto& word = tokens.list[at].word;
    if (word == "former")
      return 0;
    if (word == "last" || word == "latter")
      return size_ - 1;
    const auto number = number_at(tokens, at);
    if (!number || !number->ordinal || number->length > 1 || number->value < 1)
      return {};
    return static_cast<std::size_t>(number->value - 1);
  }

  bool keep(Choices these) {
    told_ = true;
    left_ &= these;
    return left_ != 0;
  }

  // Those that have the word; none if all have it, as it tells nothing.
  Choices those_with(std::string_view word) const {
    return of(
        [&](const auto& words) { return std::ranges::count(words, word) > 0; });
  }

  Choices those_with_letter(char letter) const {
    return of([&](const auto& words) {
      return std::ranges::any_of(words, [&](const std::string& word) {
        return word.find(letter) != std::string::npos;
      });
    });
  }

  template <class Holds>
  Choices of(Holds holds) const {
    Choices found = 0;
    for (std::size_t at = 0; at < size_; ++at)
      if (holds(words_[at]))
        found |= bit(at);
    return found == all() ? 0 : found;
  }

  std::size_t size_;
  std::vector<std::vector<std::string>> words_;
  Choices left_ = 0;
  // Something told which; all are as good; none is wanted.
  bool told_ = false;
  bool any_ = false;
  bool refused_ = false;
};

BuiltAct whole(const Utterance& utterance, std::string act) {
  BuiltAct made;
  made.act = std::move(act);
  made.end = static_cast<std::uint32_t>(utterance.size());
  made.score = 1;
  return made;
}

} // namespace

std::optional<BuiltAct> choice_of(const Utterance& utterance,
                                  const Context& context) {
  if (context.choices.size() < 2 || context.choices.size() > max_choices ||
      context.asked_topic == no_topic ||
      std::ranges::count(utterance.negates, true) > 0)
    return {};
  Chooser chooser(context.choices);
  if (!chooser.take(utterance))
    return {};
  if (chooser.refused())
    return whole(utterance, "deny");
  const auto chosen = chooser.chosen();
  if (!chosen)
    return {};
  auto act = whole(utterance, "inform");
  act.topic = context.asked_topic;
  act.elliptical = true;
  act.fills.push_back({context.asked_slot,
                       context.asked_topic,
                       {},
                       Value(context.choices[*chosen]),
                       0,
                       act.end});
  return act;
}

} // namespace parlour::adapters::nlu
