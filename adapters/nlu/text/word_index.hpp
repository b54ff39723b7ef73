// The words of all values, found exactly, in another number, or misspelt.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace parlour::adapters::nlu {

// For lookups by string_view in maps of strings.
struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const {
    return std::hash<std::string_view>()(text);
  }
};

template <class Value>
using TextMap =
    std::unordered_map<std::string, Value, TextHash, std::equal_to<>>;

// "shops" is "shop": so both are found for each other.
std::string singular(std::string_view word);

class WordIndex {
public:
  using WordId = std::uint32_t;

  struct Hit {
    WordId word = 0;
    double similarity = 1;
  };

  // The word's number; new words get the next one.
  WordId add(std::string_view word);

  // The word itself where it is there, then misspellings of it if wanted, best
  // first, not more than eight.
  std::vector<Hit> find(std::string_view word, bool misspelt) const;
  std::size_t size() const {
    return words_.size();
  }

private:
  void add_misspelt(const std::string& word, std::vector<Hit>& hits) const;

  std::vector<std::string> words_;
  TextMap<WordId> numbers_;
  std::unordered_map<std::uint32_t, std::vector<WordId>>
      near_; // by what words have in common
};

} // namespace parlour::adapters::nlu
