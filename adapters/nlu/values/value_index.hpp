// Sets of values (a slot's, a column's) and where an utterance names one of
// them: word by word in any order, with words left out, joined, split or
// misspelt, titles aside (understanding, "Names and values").
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/nlu/text/tokens.hpp"
#include "adapters/nlu/text/word_index.hpp"

namespace parlour::adapters::nlu {

using SetId = std::uint32_t;

struct ValueMatch {
  SetId set = 0;
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
  std::vector<std::uint32_t> values; // equally good ones, by their number
  double confidence = 1;
  bool whole = false; // every word of the value that counts was said
  // Enough was said, and in words that mean nothing else, for the value to be
  // meant also where none is expected.
  bool stands_alone = false;
};

class ValueIndex {
public:
  // Values that are the same text count as one.
  SetId add(const std::vector<std::string>& values);

  // All matches, by their begin. `plain` tells for each token whether it is a
  // word that has a meaning of its own, so neither a misspelt value nor part of
  // a stranger's name.
  std::vector<ValueMatch> find(const Tokens& tokens,
                               const std::vector<bool>& plain) const;

  const std::string& value(SetId set, std::uint32_t number) const {
    return values_[sets_[set] + number].text;
  }

private:
  friend class ValueSearch;

  struct Entry {
    std::string text;
    SetId set = 0;
    std::uint16_t all = 0;   // a bit for each word
    std::uint16_t heavy = 0; // those that count
  };

  // A word of a value, or two neighbouring ones written together.
  struct Posting {
    std::uint32_t value = 0;
    std::uint16_t mask = 0;
  };

  void add_value(const std::string& text, SetId set);
  void post(std::string_view word, std::uint32_t value, std::uint16_t mask);

  std::vector<Entry> values_;
  std::vector<std::uint32_t> sets_; // the first value of each
  WordIndex words_;
  std::vector<std::vector<Posting>> postings_; // by word
};

} // namespace parlour::adapters::nlu
