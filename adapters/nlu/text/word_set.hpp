// A fixed set of words that is asked for every word of every utterance, mostly
// for one that it does not have.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <unordered_set>

namespace parlour::adapters::nlu {

// Only read once it is made, by any number of threads. The words must outlive
// it.
class WordSet {
public:
  WordSet(std::initializer_list<std::string_view> words) : words_(words) {
    for (const auto word : words)
      if (!word.empty())
        lengths_[first_of(word)] |= length_of(word);
  }

  // Few words have the same first letter and the same length as one of it.
  bool contains(std::string_view word) const {
    return !word.empty() && (lengths_[first_of(word)] & length_of(word)) != 0 &&
           words_.contains(word);
  }

  // All of them, in no order.
  auto begin() const {
    return words_.begin();
  }
  auto end() const {
    return words_.end();
  }

private:
  static std::size_t first_of(std::string_view word) {
    return static_cast<unsigned char>(word.front());
  }
  // A bit for each length; the last one is for all that are longer, too.
  static std::uint32_t length_of(std::string_view word) {
    return std::uint32_t{1} << (word.size() < 31 ? word.size() : 31);
  }

  std::unordered_set<std::string_view> words_;
  std::array<std::uint32_t, 256> lengths_{}; // by first byte
};

} // namespace parlour::adapters::nlu
