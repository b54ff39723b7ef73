// Fixed sets of words, and what they mean, that are asked for every word of
// every utterance, mostly for one that they do not have.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace parlour::adapters::nlu {

// The first letters of words with their lengths: few other words have both of
// one of them.
class WordOutlines {
public:
  void add(std::string_view word) {
    if (!word.empty())
      lengths_[first_of(word)] |= length_of(word);
  }
  bool may_have(std::string_view word) const {
    return !word.empty() && (lengths_[first_of(word)] & length_of(word)) != 0;
  }

private:
  static std::size_t first_of(std::string_view word) {
    return static_cast<unsigned char>(word.front());
  }
  // A bit for each length; the last one is for all that are longer, too.
  static std::uint32_t length_of(std::string_view word) {
    return std::uint32_t{1} << (word.size() < 31 ? word.size() : 31);
  }

  std::array<std::uint32_t, 256> lengths_{}; // by first byte
};

// Only read once it is made, by any number of threads. The words must outlive
// it.
class WordSet {
public:
  WordSet(std::initializer_list<std::string_view> words) : words_(words) {
    for (const auto word : words)
      outlines_.add(word);
  }

  bool contains(std::string_view word) const {
    return outlines_.may_have(word) && words_.contains(word);
  }

  // All of them, in no order.
  auto begin() const {
    return words_.begin();
  }
  auto end() const {
    return words_.end();
  }

private:
  std::unordered_set<std::string_view> words_;
  WordOutlines outlines_;
};

// The same for what words mean.
template <class Meaning>
class WordMap {
public:
  using Entry = std::pair<const std::string_view, Meaning>;

  WordMap(std::initializer_list<Entry> entries) : meanings_(entries) {
    for (const auto& [word, meaning] : entries)
      outlines_.add(word);
  }

  // Null: it does not have the word.
  const Meaning* find(std::string_view word) const {
    if (!outlines_.may_have(word))
      return nullptr;
    const auto found = meanings_.find(word);
    return found == meanings_.end() ? nullptr : &found->second;
  }

private:
  std::unordered_map<std::string_view, Meaning> meanings_;
  WordOutlines outlines_;
};

} // namespace parlour::adapters::nlu
