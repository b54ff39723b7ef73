// Counts words, pairs and triples in sentences, and writes them as a language
// model in the ARPA format. Probabilities are interpolated with those of the
// shorter context (Witten and Bell), and unseen words get those of the shorter
// context by a back-off weight; they sum to 1 in every context.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "adapters/asr/words/sentences.hpp"

namespace parlour::adapters::asr {

// Filled on one thread, then only read.
class Trigrams {
public:
  // The sentence counts `weight` times.
  void add(const Sentence& sentence, double weight = 1);

  // The probability of a word behind two others, of which each may be
  // `Trigrams::begin`; the sentence's end is `Trigrams::end`.
  double probability(Symbol before, Symbol last, Symbol word) const;

  // Words are written as `symbols` has them. Triples that were counted less
  // than `least` are left to the back-off.
  std::string arpa(const Symbols& symbols, double least = 0) const;

  // Words and sets are numbered below these: there is room for a million.
  static constexpr Symbol begin = 0xFFFFF;
  static constexpr Symbol end = 0xFFFFE;

private:
  // What follows a context.
  struct Context {
    double count = 0;
    std::unordered_map<Symbol, double> words;

    // How much the context itself is believed, 0 to 1.
    double trust() const;
  };
  using Key = std::uint64_t;

  static Key key(Symbol before, Symbol last);
  const Context* find(Key key) const;
  double interpolated(const Context* context, Symbol word, double rest) const;
  double of_word(Symbol word) const;
  double of_pair(Symbol last, Symbol word) const;

  Context words_;
  std::unordered_map<Key, Context> pairs_;   // by the last word
  std::unordered_map<Key, Context> triples_; // by the last two
};

} // namespace parlour::adapters::asr
