// Building the index. Each value may have up to 16 words, one bit each in a
// mask. Light words are indexed but not required.
#include "adapters/nlu/values/value_index.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// As many as a mask has bits.
constexpr std::size_t max_words = 16;

// The words by which a value is known. Titles are left out, unless the value
// consists of nothing else.
std::vector<std::string> value_words(const std::string& text) {
  std::vector<std::string> words;
  for (auto& token : tokenize(text).list)
    words.push_back(std::move(token.word));
  auto rest = words;
  std::erase_if(rest, [](const std::string& word) { return is_title(word); });
  if (!rest.empty())
    words = std::move(rest);
  if (words.size() > max_words)
    words.resize(max_words);
  return words;
}

// Whether the set looks like a list of people: enough values, nearly all of
// two to six words that begin with a capital letter (but for "bin" and "s/o"),
// without digits.
constexpr std::size_t least_people = 10;

bool is_persons_name(const std::string& text) {
  std::size_t words = 0;
  std::size_t capitals = 0;
  bool begins = true;
  for (const char letter : text) {
    if (letter >= '0' && letter <= '9')
      return false;
    if (begins && letter != ' ')
      ++words;
    if (begins && letter >= 'A' && letter <= 'Z')
      ++capitals;
    begins = letter == ' ';
  }
  return words >= 2 && words <= 6 && capitals + 1 >= words;
}

bool are_people(const std::vector<std::string>& values) {
  const auto named =
      static_cast<std::size_t>(std::ranges::count_if(values, is_persons_name));
  return values.size() >= least_people && named * 10 >= values.size() * 9;
}

// Of so many values can be told whether a set is one of things, and of words
// with so many letters whether a value is one.
constexpr std::size_t enough_values = 100;
constexpr std::size_t least_letters = 4;

bool is_in_small_letters(const std::string& text) {
  return !text.empty() && text[0] >= 'a' && text[0] <= 'z';
}

std::uint16_t bit(std::size_t position) {
  return static_cast<std::uint16_t>(1U << position);
}

} // namespace

SetId ValueIndex::add(const std::vector<std::string>& values) {
  const auto set = static_cast<SetId>(sets_.size());
  sets_.push_back(
      {static_cast<std::uint32_t>(values_.size()), are_people(values), {}});
  std::unordered_set<std::string_view> seen;
  for (const auto& value : values)
    if (seen.insert(value).second)
      add_value(value, set);
  if (auto& added = sets_.back(); added.of_people)
    for (auto value = added.first; value < values_.size(); ++value)
      added.sounds.push_back(sounds_of_name(value_words(values_[value].text)));
  return set;
}

bool ValueIndex::has_things(SetId set) const {
  const std::size_t first = sets_[set].first;
  const std::size_t last =
      set + 1U < sets_.size() ? sets_[set + 1U].first : values_.size();
  const auto step = std::max<std::size_t>(1, (last - first) / enough_values);
  std::size_t all = 0;
  std::size_t things = 0;
  for (auto value = first; value < last; value += step, ++all)
    things += is_thing(values_[value]) ? 1U : 0U;
  return things * 4 >= all;
}

// Whether it has a word of a value that is written in small letters: where
// "coffee shop" is one, "Harbour Coffee" is no person.
bool ValueIndex::is_thing(const Entry& value) const {
  const auto words = value_words(value.text);
  return std::ranges::any_of(words, [&](const std::string& word) {
    return words_of_things_.contains(word);
  });
}

void ValueIndex::add_value(const std::string& text, SetId set) {
  const auto number = static_cast<std::uint32_t>(values_.size());
  const auto words = value_words(text);
  Entry entry{text, set, 0, 0};
  // "coffee shop" is found as "coffeeshop", too.
  for (std::size_t at = 0; at < words.size(); ++at) {
    entry.all |= bit(at);
    if (!is_light(words[at]))
      entry.heavy |= bit(at);
    words_.add(words[at], {number, bit(at)});
    if (is_in_small_letters(text) && !is_light(words[at]) &&
        words[at].size() >= least_letters)
      words_of_things_.insert(words[at]);
    if (at > 0)
      joined_.add(words[at - 1] + words[at],
                  {number, static_cast<std::uint16_t>(bit(at - 1) | bit(at))});
  }
  // A value of light words only ("the at") needs all of them.
  if (entry.heavy == 0)
    entry.heavy = entry.all;
  values_.push_back(std::move(entry));
}

void ValueIndex::Lists::add(std::string_view word, Posting posting) {
  const auto number = index.add(word);
  postings.resize(index.size());
  postings[number].push_back(posting);
}

void ValueIndex::add_synonyms(
    const std::vector<std::vector<std::string>>& groups) {
  TextMap<std::vector<std::string>> others;
  for (const auto& group : groups)
    for (const auto& word : group)
      if (!is_function_word(word) && !has_word(word))
        for (const auto& other : group)
          others[other].push_back(word);
  for (std::uint32_t value = 0; value < values_.size(); ++value) {
    const auto& text = values_[value].text;
    if (!is_in_small_letters(text))
      continue;
    const auto words = value_words(text);
    for (std::size_t at = 0; at < words.size(); ++at)
      if (const auto found = others.find(words[at]); found != others.end())
        for (const auto& other : found->second)
          synonyms_[other].push_back({value, bit(at)});
  }
}

} // namespace parlour::adapters::nlu
