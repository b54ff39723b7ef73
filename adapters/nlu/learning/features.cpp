#include "adapters/nlu/learning/features.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "adapters/nlu/text/hash.hpp"

namespace parlour::adapters::nlu {

namespace {

// Lengths of the pieces of words, and of the longest beginning and ending.
constexpr std::size_t shortest_piece = 3;
constexpr std::size_t longest_piece = 4;
constexpr std::size_t longest_affix = 4;

// `kind` is a letter that separates features which are made of the same words.
constexpr Feature feature(char kind, std::string_view first) {
  return hash_of(first, hash_of({&kind, 1}));
}

constexpr Feature feature(char kind, std::string_view first,
                          std::string_view second) {
  return hash_of(second, hash_of(" ", feature(kind, first)));
}

constexpr Feature feature(char kind, std::string_view first,
                          std::string_view second, std::string_view third) {
  return hash_of(third, hash_of(" ", feature(kind, first, second)));
}

constexpr Feature of_class(FeatureClass kind, Feature feature) {
  return (feature & ~class_bits) | static_cast<Feature>(kind);
}

constexpr Feature plain(Feature feature) {
  return of_class(FeatureClass::plain, feature);
}

// The pieces of "^want$": ^wa, wan, ant, nt$, ^wan …
void add_pieces(std::string_view word, std::vector<Feature>& made) {
  std::string framed = "^";
  framed.append(word).append("$");
  for (auto length = shortest_piece; length <= longest_piece; ++length)
    for (std::size_t at = 0; at + length <= framed.size(); ++at)
      made.push_back(
          plain(feature('p', std::string_view(framed).substr(at, length))));
}

std::string kind_name(std::uint32_t kind) {
  return '@' + std::to_string(kind);
}

// The words, with one kind in the place of all words of a value. What means
// nothing is left out: with it or without, a sentence is about the same.
std::vector<std::string>
without_values(const std::vector<LearningWord>& words) {
  std::vector<std::string> made;
  std::uint32_t before = 0;
  for (const auto& one : words) {
    if (one.filler && one.kind == 0)
      continue;
    if (one.kind == 0)
      made.emplace_back(one.word);
    else if (one.kind != before)
      made.push_back(kind_name(one.kind));
    before = one.kind;
  }
  return made;
}

// Computes the features of one position after another.
class WordFeatures {
public:
  explicit WordFeatures(const std::vector<LearningWord>& words)
      : words_(words) {}

  std::vector<Feature> at(std::size_t position) {
    made_ = {feature('0', "")};
    at_ = position;
    add_neighbours();
    add_affixes(word(0));
    add_kinds();
    add_groups();
    return std::move(made_);
  }

private:
  std::size_t place(int away) const {
    // A position before the first word wraps, and is beyond the last one.
    return at_ + static_cast<std::size_t>(away);
  }

  // "^" before the first word, "$" behind the last one.
  std::string_view word(int away) const {
    if (place(away) >= words_.size())
      return away < 0 ? "^" : "$";
    return words_[place(away)].word;
  }

  std::string kind(int away) const {
    const bool inside = place(away) < words_.size();
    return kind_name(inside ? words_[place(away)].kind : 0);
  }

  // Words and pairs of words up to two positions away. The letters from 'a' on
  // say how far away they are.
  void add_neighbours() {
    for (int away = -2; away <= 2; ++away)
      made_.push_back(feature(static_cast<char>('c' + away), word(away)));
    for (int away = -2; away <= 1; ++away)
      made_.push_back(
          feature(static_cast<char>('h' + away), word(away), word(away + 1)));
    made_.push_back(feature('k', word(-1), word(1)));
    made_.push_back(feature('l', word(-2), word(-1), word(0)));
  }

  void add_affixes(std::string_view word) {
    for (std::size_t length = 1; length <= longest_affix; ++length) {
      if (length >= word.size())
        return;
      made_.push_back(feature('m', word.substr(0, length)));
      made_.push_back(feature('n', word.substr(word.size() - length)));
    }
  }

  void add_kinds() {
    for (int away = -1; away <= 1; ++away)
      made_.push_back(feature(static_cast<char>('q' + away), kind(away)));
    // A change of kind is where a value begins.
    made_.push_back(feature('t', kind(-1), kind(0)));
  }

  // The words up to two positions away, as far as they have a meaning.
  void add_groups() {
    for (int away = -2; away <= 2; ++away) {
      if (place(away) >= words_.size())
        continue;
      const auto& meaning = words_[place(away)].meaning;
      if (meaning.group == 0)
        continue;
      made_.push_back(feature(static_cast<char>('C' + away),
                              std::to_string(meaning.group)));
      made_.push_back(feature(static_cast<char>('H' + away),
                              std::to_string(meaning.smaller_group)));
    }
  }

  const std::vector<LearningWord>& words_;
  std::size_t at_ = 0;
  std::vector<Feature> made_;
};

// The sum of what the words mean, made to a vector of length 1.
std::vector<float> meaning_of(const std::vector<LearningWord>& words) {
  std::vector<float> sum;
  for (const auto& word : words) {
    if (word.kind != 0)
      continue;
    const auto& meaning = word.meaning;
    sum.resize(std::max(sum.size(), meaning.steps.size()));
    for (std::size_t at = 0; at < meaning.steps.size(); ++at)
      sum[at] +=
          meaning.step *
          static_cast<float>(static_cast<signed char>(meaning.steps[at]));
  }
  float length = 0;
  for (const auto number : sum)
    length += number * number;
  if (length == 0)
    return {};
  for (auto& number : sum)
    number /= std::sqrt(length);
  return sum;
}

} // namespace

TextFeatures text_features(const std::vector<LearningWord>& words) {
  std::vector<Feature> made;
  std::string before = "^";
  for (const auto& word : without_values(words)) {
    const bool is_kind = word.starts_with('@');
    made.push_back(
        of_class(is_kind ? FeatureClass::kind_of_value : FeatureClass::plain,
                 feature('w', word)));
    made.push_back(plain(feature('b', before, word)));
    if (!is_kind)
      add_pieces(word, made);
    before = word;
  }
  made.push_back(plain(feature('b', before, "$")));
  for (const auto& word : words)
    if (word.kind != 0)
      made.push_back(
          of_class(FeatureClass::word_of_value, feature('v', word.word)));
  std::ranges::sort(made);
  made.erase(std::unique(made.begin(), made.end()), made.end());
  return {std::move(made), meaning_of(words)};
}

std::vector<std::vector<Feature>>
word_features(const std::vector<LearningWord>& words) {
  std::vector<std::vector<Feature>> made;
  WordFeatures features(words);
  for (std::size_t at = 0; at < words.size(); ++at)
    made.push_back(features.at(at));
  return made;
}

} // namespace parlour::adapters::nlu
