#include "adapters/nlu/word_index.hpp"

#include <algorithm>

#include "adapters/nlu/similarity.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t most_hits = 8;
constexpr std::size_t shortest_misspelt = 3;
constexpr std::size_t most_extra = 3; // letters

std::uint32_t trigram(const std::string& padded, std::size_t position) {
  std::uint32_t key = 0;
  for (std::size_t offset = 0; offset < 3; ++offset)
    key = key << 8 | static_cast<unsigned char>(padded[position + offset]);
  return key;
}

// Each trigram of the word with its ends marked, once.
std::vector<std::uint32_t> trigrams_of(const std::string& word) {
  const auto padded = '^' + word + '$';
  std::vector<std::uint32_t> keys;
  for (std::size_t position = 0; position + 3 <= padded.size(); ++position)
    keys.push_back(trigram(padded, position));
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
    for (const auto gram : trigrams_of(key))
      trigrams_[gram].push_back(number);
    words_.push_back(std::move(key));
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

void WordIndex::add_misspelt(const std::string& word,
                             std::vector<Hit>& hits) const {
  std::vector<WordId> near;
  for (const auto gram : trigrams_of(word))
    if (const auto found = trigrams_.find(gram); found != trigrams_.end())
      near.insert(near.end(), found->second.begin(), found->second.end());
  std::ranges::sort(near);
  const std::size_t shared = word.size() > 5 ? 2 : 1;
  for (std::size_t at = 0; at < near.size();) {
    const auto first = at;
    while (at < near.size() && near[at] == near[first])
      ++at;
    const auto& other = words_[near[first]];
    if (at - first < shared || other == word || other.size() < 2)
      continue;
    const auto length = std::min(word.size(), other.size());
    if (std::max(word.size(), other.size()) > length + most_extra)
      continue;
    const auto alike = similarity(word, other);
    if (alike >= similarity_needed(length))
      hits.push_back({near[first], alike});
  }
  std::ranges::stable_sort(hits, std::greater(), &Hit::similarity);
  if (hits.size() > most_hits)
    hits.resize(most_hits);
}

} // namespace parlour::adapters::nlu
