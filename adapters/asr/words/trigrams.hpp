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

// Words and sets are numbered below these: there is room for a million.
inline constexpr Symbol sentence_begin = 0xFFFFF;
inline constexpr Symbol sentence_end = 0xFFFFE;

// How often each word was said behind two others; pairs and words follow from
// that.
class TrigramCounts {
public:
  // Three symbols in one number.
  using Key = std::uint64_t;
  using Counts = std::unordered_map<Key, double>;

  static Key key(Symbol before, Symbol last, Symbol word);

  // The sentence counts `weight` times. Its end is a word, too.
  void add(const Sentence& sentence, double weight = 1);

  const Counts& triples() const {
    return triples_;
  }

private:
  Counts triples_;
};

// Immutable after it was made.
class Trigrams {
public:
  explicit Trigrams(const TrigramCounts& counts);

  // The probability of a word behind two others, of which each may be
  // `sentence_begin`; the end is `sentence_end`.
  double probability(Symbol before, Symbol last, Symbol word) const;

  // Words are written as `symbols` has them. Triples that were counted less
  // than `least` are left to the back-off.
  std::string arpa(const Symbols& symbols, double least = 0) const;

private:
  using Key = TrigramCounts::Key;

  // What words follow in.
  struct Context {
    double count = 0;
    std::size_t words = 0; // different ones

    // How much the context itself is believed, 0 to 1.
    double trust() const;
  };
  // Contexts, and the words in them, each by the words that they consist of.
  struct Order {
    std::unordered_map<Key, Context> contexts;
    TrigramCounts::Counts counts;

    void count(Key context, Key with_word, double times);
    double interpolated(Key context, Key with_word, double rest) const;
    // The logarithm of what is left for words that were not seen there.
    double back_off(Key context) const;
  };

  double of_word(Symbol word) const;
  double of_pair(Symbol last, Symbol word) const;

  Order words_;   // in the one context `nothing`
  Order pairs_;   // by the last word
  Order triples_; // by the last two
};

} // namespace parlour::adapters::asr
