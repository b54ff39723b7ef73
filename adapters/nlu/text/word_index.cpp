#include "adapters/nlu/text/word_index.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "adapters/nlu/text/similarity.hpp"
#include "adapters/nlu/text/sounds.hpp"

namespace parlour::adapters::nlu {

namespace {

// A misspelling is looked for only if the word has at least three letters,
// among words whose length differs by at most three.
constexpr std::size_t max_hits = 8;
constexpr std::size_t shortest_misspelt = 3;
constexpr std::size_t max_extra = 3;
constexpr std::size_t longest_short = 5;
// How similar words are at least that sound alike: less than what is accepted
// without a word about it.
constexpr double similar_by_sound = 0.8;

// Three bytes as one number.
std::uint32_t trigram(const std::string& padded, std::size_t position) {
  std::uint32_t key = 0;
  for (std::size_t offset = 0; offset < 3; ++offset)
    key = key << 8 | static_cast<unsigned char>(padded[position + offset]);
  return key;
}

// A short word has few trigrams, and one wrong letter changes all of them. So
// words with the same first and last letter ("omg", "ong") and words of the
// same letters ("tna", "tan") share a key as well. The high byte, which is 0 in
// a trigram, keeps the kinds of keys apart.
void add_keys_of_short(std::string word, std::vector<std::uint32_t>& keys) {
  const auto byte = [&](std::size_t at) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(word[at]));
  };
  keys.push_back(0x0100'0000U | byte(0) << 8 | byte(word.size() - 1));
  std::ranges::sort(word);
  std::uint32_t letters = 0;
  for (std::size_t at = 0; at < word.size(); ++at)
    letters = letters * 31 + byte(at);
  keys.push_back(0x0200'0000U | (letters & 0x00FF'FFFFU));
}

std::uint32_t key_of_sound(const std::string& sound) {
  std::uint32_t key = 0;
  for (const char one : sound)
    key = key * 31 + static_cast<unsigned char>(one);
  return 0x0300'0000U | (key & 0x00FF'FFFFU);
}

// The keys of a word, sorted and without duplicates: its trigrams, with its
// ends marked by ^ and $, and its sound.
std::vector<std::uint32_t> keys_of(const std::string& word,
                                   const std::string& sound) {
  const auto padded = '^' + word + '$';
  std::vector<std::uint32_t> keys;
  for (std::size_t position = 0; position + 3 <= padded.size(); ++position)
    keys.push_back(trigram(padded, position));
  if (!word.empty() && word.size() <= longest_short)
    add_keys_of_short(word, keys);
  if (sound.size() > 1)
    keys.push_back(key_of_sound(sound));
  std::ranges::sort(keys);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

} // namespace

std::string singular(std::string_view word) {
  if (word.size() > 4 && word.ends_with("ies"))
    return std::string(word.substr(0, word.size() - 3)) + 'y';
  if (word.size() > 4 && (word.ends_with("ches") || word.ends_with("shes") ||
                          word.ends_with("xes") || word.ends_with("sses")))
    return std::string(word.substr(0, word.size() - 2));
  if (word.size() > 3 && word.ends_with('s') && !word.ends_with("ss") &&
      !word.ends_with("us"))
    return std::string(word.substr(0, word.size() - 1));
  return std::string(word);
}

WordIndex::WordId WordIndex::add(std::string_view word) {
  auto key = singular(word);
  const auto number = static_cast<WordId>(words_.size());
  const auto [place, is_new] = numbers_.try_emplace(key, number);
  if (is_new) {
    auto sound = sound_of(key);
    for (const auto gram : keys_of(key, sound))
      near_[gram].push_back(number);
    words_.push_back(std::move(key));
    sounds_.push_back(std::move(sound));
  }
  return place->second;
}

std::vector<WordIndex::Hit> WordIndex::find(std::string_view word,
                                            bool misspelt) const {
  std::vector<Hit> hits;
  const auto key = singular(word);
  if (const auto found = numbers_.find(key); found != numbers_.end())
    hits.push_back({found->second, 1});
  if (misspelt && key.size() >= shortest_misspelt)
    add_misspelt(key, hits);
  return hits;
}

// Collects all words that share a key with `word` and compares those that share
// enough: two keys, or one for a short word. Sorting groups equal numbers, so
// the length of a group is the number of shared keys. Computing the similarity,
// the expensive part, is thus done for few words only.
void WordIndex::add_misspelt(const std::string& word,
                             std::vector<Hit>& hits) const {
  std::vector<WordId> near;
  const auto sound = sound_of(word);
  for (const auto gram : keys_of(word, sound))
    if (const auto found = near_.find(gram); found != near_.end())
      near.insert(near.end(), found->second.begin(), found->second.end());
  std::ranges::sort(near);
  const std::size_t shared = word.size() > 5 ? 2 : 1;
  for (std::size_t at = 0; at < near.size();) {
    const auto first = at;
    while (at < near.size() && near[at] == near[first])
      ++at;
    const auto& other = words_[near[first]];
    if (other == word || other.size() < 2)
      continue;
    const bool by_sound = sound.size() > 1 && sound == sounds_[near[first]];
    if (at - first < shared && !by_sound)
      continue;
    const auto length = std::min(word.size(), other.size());
    if (std::max(word.size(), other.size()) > length + max_extra)
      continue;
    const auto alike =
        std::max(similarity(word, other), by_sound ? similar_by_sound : 0.0);
    if (alike >= similarity_needed(length))
      hits.push_back({near[first], alike});
  }
  std::ranges::stable_sort(hits, std::greater(), &Hit::similarity);
  if (hits.size() > max_hits)
    hits.resize(max_hits);
}

} // namespace parlour::adapters::nlu
