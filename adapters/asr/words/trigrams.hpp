// Counts words, pairs and triples in sentences, and writes them as a language
// model in the ARPA format. Probabilities are interpolated with those of the
// shorter context (Witten and Bell), and unseen words get those of the shorter
// context by a back-off weight; they sum to 1 in every context of which nothing
// is left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
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
  struct Counted {
    std::uint64_t key = 0; // three symbols in one number
    double times = 0;
  };

  static std::uint64_t key(Symbol before, Symbol last, Symbol word);

  // The sentence counts `weight` times. Its end is a word, too.
  void add(const Sentence& sentence, double weight = 1);

  // Takes less memory then: each triple is there once.
  void unite();

  bool empty() const {
    return said_.empty();
  }
  // Each once, in the order of their keys.
  std::vector<Counted> triples() const;
  // With other symbols; those that become one are counted together. The
  // sentences' begins and ends stay.
  TrigramCounts renamed(const std::function<Symbol(Symbol)>& name) const;

private:
  std::vector<Counted> said_;
};

// Immutable after it was made. It is a tree: below each word are those that
// were said behind it, and below each of these what was said behind both.
class Trigrams {
public:
  // A word in its context: the rows above it.
  struct Row {
    Symbol word = 0;
    double times = 0;
    double probability = 0;
    // Of all words behind this one, what is left for those not seen there.
    double left = 1;
  };
  struct Order {
    // By the symbols of their words, below each row of the order above.
    std::vector<Row> rows;
    // Where the rows below each row of the order above begin; the end.
    std::vector<std::uint32_t> begins;

    std::span<const Row> below(std::size_t above) const;
  };

  // Triples that were counted less than `least` are left to the pairs.
  explicit Trigrams(const TrigramCounts& counts, double least = 0);

  // The last of the words is `sentence_begin`, which is only a context.
  const Order& words() const {
    return words_;
  }
  const Order& pairs() const {
    return pairs_;
  }
  const Order& triples() const {
    return triples_;
  }

  // The index of a word's row; the number of rows for an unknown one.
  std::size_t word_at(Symbol word) const;

  // The probability of a word behind two others, of which each may be
  // `sentence_begin`; the end is `sentence_end`.
  double probability(Symbol before, Symbol last, Symbol word) const;

  // Words are written as word_text() has them.
  std::string arpa(const Symbols& symbols) const;

private:
  void weigh();
  void leave_out(double least);
  double of_word(Symbol word) const;
  double of_pair(Symbol last, Symbol word) const;

  Order words_; // all below one
  Order pairs_;
  Order triples_;
};

// "<s>" and "</s>" where a sentence begins and ends.
std::string word_text(Symbol symbol, const Symbols& symbols);

} // namespace parlour::adapters::asr
