// WordVectors tells which words mean something alike: each word has numbers,
// which are close to those of words that people use in the same places ("cab",
// "taxi"). They come from a file that tools/words makes, and everything works
// without it, only with more examples.
//
//  const auto vectors = WordVectors::read("config/platform/words.vectors");
//  const auto cab = (*vectors)->find("cab");
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour::adapters::nlu {

// All empty for a word without numbers.
struct WordMeaning {
  // A signed byte for each number. Not owned: part of the WordVectors.
  std::string_view steps;
  // What one step is worth: the vector's length is 1, and less for words that
  // occur everywhere.
  float step = 0;
  // Words of one group are alike, those of a smaller one still more; 0: none.
  std::uint16_t group = 0;
  std::uint16_t smaller_group = 0;
};

// Immutable; any number of threads may use it.
class WordVectors {
public:
  // The file: "PARLOURW", the number of words and of numbers for each (32
  // bits); then for each word its hash (FNV-1a, 64 bits), what a step is worth
  // (a float), its two groups (16 bits each) and its numbers (8 bits each). All
  // in the processor's order, which is little-endian; words are sorted by hash.
  // Errors are of kind File.
  static Expected<std::shared_ptr<const WordVectors>>
  read(const std::filesystem::path& path);

  // `word` in small letters.
  WordMeaning find(std::string_view word) const;

  bool operator==(const WordVectors&) const = default;

private:
  WordVectors(std::string bytes, std::size_t words, std::size_t record);

  std::uint64_t hash_at(std::size_t number) const;

  std::string bytes_; // the whole file
  std::size_t words_ = 0;
  std::size_t record_ = 0; // bytes for each word
};

} // namespace parlour::adapters::nlu
