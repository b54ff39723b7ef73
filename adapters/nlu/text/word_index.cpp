#include "adapters/nlu/text/word_index.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "adapters/nlu/text/phones.hpp"
#include "adapters/nlu/text/similarity.hpp"
#include "adapters/nlu/text/sounds.hpp"

namespace parlour::adapters::nlu {

namespace {

// A misspelling is looked for only if the word has at least two letters,
// among words whose length differs by at most three.
constexpr std::size_t max_hits = 8;
constexpr std::size_t shortest_misspelt = 2;
constexpr std::size_t max_extra = 3;
// The same for words that must be nearly the same: "jeffery" is not
// "jefferyho".
constexpr double nearly_the_same = 0.9;
constexpr std::size_t extra_of_nearly = 1;
constexpr std::size_t longest_short = 5;
// How similar words are at least that sound alike: less than what is accepted
// without a word about it.
constexpr double similar_by_sound = 0.8;
// How alike words sound at least, those that are said the same, and what the
// spelling costs of words that are not written alike.
constexpr double least_alike = 0.72;
constexpr double said_the_same = 0.9;
constexpr double other_spelling = 0.95;

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

std::uint32_t key_of(std::string_view sounds, std::uint32_t kind) {
  std::uint32_t key = 0;
  for (const char one : sounds)
    key = key * 31 + static_cast<unsigned char>(one);
  return kind << 24 | (key & 0x00FF'FFFFU);
}

std::uint32_t key_of_sound(std::string_view sound) {
  return key_of(sound, 3);
}

// The kinds of its consonants; of words that hardly have any, the first sound
// as well: "ai", "hui".
std::uint32_t key_of_phones(std::string_view phones) {
  auto outline = outline_of(phones);
  if (outline.size() < 2 && !phones.empty())
    outline += phones.back();
  return key_of(outline, 4);
}

// What similar words of different lengths share, in lists of their own: only
// lengths that may be meant are looked at.
std::uint64_t with_length(std::uint32_t key, std::size_t length) {
  return std::uint64_t(length) << 32 | key;
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

// The keys of a word, sorted and without duplicates: its trigrams, with its
// ends marked by ^ and $, and its sound.
std::vector<std::uint32_t> WordIndex::keys_of(const Word& word) {
  const auto& letters = word.letters;
  const auto padded = '^' + letters + '$';
  std::vector<std::uint32_t> keys;
  keys.reserve(padded.size() + 4);
  for (std::size_t position = 0; position + 3 <= padded.size(); ++position)
    keys.push_back(trigram(padded, position));
  if (!letters.empty() && letters.size() <= longest_short)
    add_keys_of_short(letters, keys);
  if (word.sound.size() > 1)
    keys.push_back(key_of_sound(word.sound));
  if (word.outline != 0)
    keys.push_back(word.outline);
  std::ranges::sort(keys);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

WordIndex::Word WordIndex::read(std::string letters) {
  auto phones = phones_of(letters);
  const auto phone_bits = sounds_in(phones);
  const auto letter_bits = letters_in(letters);
  auto sound = sound_of(letters);
  const auto outline = phones.empty() ? 0 : key_of_phones(phones);
  return {std::move(letters), letter_bits, std::move(sound),
          std::move(phones),  phone_bits,  outline};
}

WordIndex::WordId WordIndex::add(std::string_view word) {
  auto key = singular(word);
  const auto number = static_cast<WordId>(words_.size());
  const auto [place, is_new] = numbers_.try_emplace(key, number);
  if (is_new) {
    auto made = read(std::move(key));
    for (const auto shared : keys_of(made))
      near_[with_length(shared, made.letters.size())].push_back(number);
    words_.push_back(std::move(made));
  }
  return place->second;
}

std::vector<WordIndex::Hit> WordIndex::find(std::string_view word,
                                            Spelling spelling) const {
  std::vector<Hit> hits;
  const auto key = singular(word);
  if (const auto found = numbers_.find(key); found != numbers_.end())
    hits.push_back({found->second, 1});
  if (spelling != Spelling::exact && key.size() >= shortest_misspelt)
    add_misspelt(key, spelling, hits);
  return hits;
}

std::vector<WordIndex::Hit>
WordIndex::find_said_alike(std::string_view word) const {
  std::vector<Hit> hits;
  const auto phones = phones_of(word);
  if (phones.size() < 2)
    return hits;
  const auto outline = key_of_phones(phones);
  for (std::size_t length = 1; length <= word.size() + max_extra; ++length)
    if (const auto found = near_.find(with_length(outline, length));
        found != near_.end())
      for (const auto number : found->second)
        if (const auto alike =
                sounds_alike(phones, words_[number].phones, said_the_same);
            alike >= said_the_same)
          hits.push_back({number, alike * other_spelling});
  sort(hits);
  return hits;
}

void WordIndex::sort(std::vector<Hit>& hits) {
  std::ranges::stable_sort(hits, std::greater(), &Hit::similarity);
  if (hits.size() > max_hits)
    hits.resize(max_hits);
}

// Collects all words that share a key with `word`. Sorting groups equal
// numbers, so the length of a group is the number of shared keys.
void WordIndex::add_misspelt(const std::string& word, Spelling spelling,
                             std::vector<Hit>& hits) const {
  const bool nearly = spelling == Spelling::nearly;
  const Heard heard{read(word), nearly ? nearly_the_same : 0,
                    nearly ? extra_of_nearly : max_extra};
  const auto keys = keys_of(heard.word);
  std::vector<WordId> near;
  const auto shortest = std::max(word.size(), heard.extra + 2) - heard.extra;
  for (auto length = shortest; length <= word.size() + heard.extra; ++length)
    for (const auto key : keys)
      if (const auto found = near_.find(with_length(key, length));
          found != near_.end())
        near.insert(near.end(), found->second.begin(), found->second.end());
  std::ranges::sort(near);
  for (std::size_t at = 0; at < near.size();) {
    const auto first = at;
    while (at < near.size() && near[at] == near[first])
      ++at;
    if (const auto hit = compare(heard, near[first], at - first);
        hit.similarity > 0)
      hits.push_back(hit);
  }
  sort(hits);
}

// How alike the two words are, with 0 if they are not alike enough. They are
// only compared if they share enough keys: two, or one for a short word. The
// comparison, which is the expensive part, is thus done for few words only.
WordIndex::Hit WordIndex::compare(const Heard& heard, WordId number,
                                  std::size_t shared) const {
  const auto& word = heard.word;
  const auto& known = words_[number];
  const bool near = shared >= (word.letters.size() > 5 ? 2U : 1U);
  const bool by_sound = word.sound.size() > 1 && word.sound == known.sound;
  const bool by_outline = word.outline != 0 && word.outline == known.outline;
  if ((!near && !by_sound && !by_outline) || known.letters == word.letters)
    return {number, 0};
  const auto said = alike_when_said(heard, known);
  const auto [shorter, longer] =
      std::minmax({word.letters.size(), known.letters.size()});
  const auto needed = std::max(similarity_needed(shorter), heard.least);
  const bool may_be_similar =
      (near || by_sound) &&
      similarity_at_most(word.letter_bits, known.letter_bits, longer) >= needed;
  const auto letters =
      may_be_similar ? similarity(word.letters, known.letters, needed) : 0.0;
  const auto written = std::max(
      letters >= needed ? letters : 0.0,
      by_sound && similar_by_sound >= heard.least ? similar_by_sound : 0.0);
  return {number, std::max(written, said), written == 0};
}

// 0 if they are not alike enough.
double WordIndex::alike_when_said(const Heard& heard, const Word& known) {
  const auto& phones = heard.word.phones;
  const auto [shorter, longer] =
      std::minmax({phones.size(), known.phones.size()});
  const auto least = std::max(least_alike, heard.least);
  const auto needed = least / other_spelling;
  if (longer > shorter + max_extra ||
      sounds_alike_at_most(heard.word.phone_bits, known.phone_bits, longer) <
          needed)
    return 0;
  const auto alike =
      sounds_alike(phones, known.phones, needed) * other_spelling;
  return alike >= least ? alike : 0;
}

} // namespace parlour::adapters::nlu
