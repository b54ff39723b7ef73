#include "adapters/asr/words/trigrams.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::asr {

namespace {

// In place of words that do not belong to a shorter context.
constexpr Symbol nothing = 0xFFFFD;
constexpr unsigned bits = 20; // of a symbol

using Key = TrigramCounts::Key;

Key pair_of(Symbol last, Symbol word) {
  return TrigramCounts::key(nothing, last, word);
}

Key word_of(Symbol word) {
  return pair_of(nothing, word);
}

Symbol symbol_at(Key key, unsigned place) {
  return static_cast<Symbol>(key >> place * bits) & ((1U << bits) - 1);
}

std::string text_of(Symbol symbol, const Symbols& symbols) {
  return symbol == sentence_begin ? "<s>"
         : symbol == sentence_end ? "</s>"
                                  : symbols.text(symbol);
}

double decimal_logarithm(double probability) {
  return probability > 0 ? std::log10(probability) : -99;
}

} // namespace

Key TrigramCounts::key(Symbol before, Symbol last, Symbol word) {
  return (static_cast<Key>(before) << bits | last) << bits | word;
}

void TrigramCounts::add(const Sentence& sentence, double weight) {
  auto before = sentence_begin;
  auto last = sentence_begin;
  for (const auto word : sentence) {
    triples_[key(before, last, word)] += weight;
    before = std::exchange(last, word);
  }
  triples_[key(before, last, sentence_end)] += weight;
}

// -- contexts -----------------------------------------------------------------

// Witten and Bell: a context that was followed by many different words is
// believed less, as others may follow it, too.
double Trigrams::Context::trust() const {
  return count > 0 ? count / (count + static_cast<double>(words)) : 0;
}

void Trigrams::Order::count(Key context, Key with_word, double times) {
  auto& counted = counts[with_word];
  auto& in = contexts[context];
  in.words += counted == 0 ? 1 : 0;
  in.count += times;
  counted += times;
}

// `rest` is the probability in the shorter context.
double Trigrams::Order::interpolated(Key context, Key with_word,
                                     double rest) const {
  const auto in = contexts.find(context);
  if (in == contexts.end())
    return rest;
  const auto found = counts.find(with_word);
  const auto own = found == counts.end() ? 0 : found->second / in->second.count;
  const auto trust = in->second.trust();
  return trust * own + (1 - trust) * rest;
}

double Trigrams::Order::back_off(Key context) const {
  const auto in = contexts.find(context);
  return in == contexts.end() ? 0 : decimal_logarithm(1 - in->second.trust());
}

// -- the model ----------------------------------------------------------------

Trigrams::Trigrams(const TrigramCounts& counts) {
  for (const auto& [key, times] : counts.triples()) {
    const auto word = symbol_at(key, 0);
    const auto last = symbol_at(key, 1);
    words_.count(word_of(nothing), word_of(word), times);
    pairs_.count(word_of(last), pair_of(last, word), times);
    triples_.count(pair_of(symbol_at(key, 2), last), key, times);
  }
}

// The shortest context has a shorter one still: all words equally probable.
double Trigrams::of_word(Symbol word) const {
  const auto size =
      static_cast<double>(std::max<std::size_t>(1, words_.counts.size()));
  return words_.interpolated(word_of(nothing), word_of(word), 1 / size);
}

double Trigrams::of_pair(Symbol last, Symbol word) const {
  return pairs_.interpolated(word_of(last), pair_of(last, word), of_word(word));
}

double Trigrams::probability(Symbol before, Symbol last, Symbol word) const {
  return triples_.interpolated(pair_of(before, last),
                               TrigramCounts::key(before, last, word),
                               of_pair(last, word));
}

// What stands in the file for a known triple is the interpolated probability;
// for the others, the reader multiplies that of the pair by the back-off
// weight, which is the trust that is left.
//
// A line of the file is the logarithm of a probability, the words, and the
// logarithm of the back-off weight: "-1.2041 coffee shop -0.3010".
std::string Trigrams::arpa(const Symbols& symbols, double least) const {
  fmt::memory_buffer one;
  fmt::memory_buffer two;
  fmt::memory_buffer three;
  std::size_t ones = 1;
  std::size_t twos = 0;
  std::size_t threes = 0;
  auto write = [&](fmt::memory_buffer& to, double probability,
                   const auto&... words) {
    fmt::format_to(std::back_inserter(to), "{:.4f}",
                   decimal_logarithm(probability));
    (fmt::format_to(std::back_inserter(to), " {}", words), ...);
  };
  auto end_line = [](fmt::memory_buffer& to, double weight) {
    fmt::format_to(std::back_inserter(to), " {:.4f}\n", weight);
  };
  // <s> is never said; it is a context only.
  fmt::format_to(std::back_inserter(one), "-99 <s> {:.4f}\n",
                 pairs_.back_off(word_of(sentence_begin)));
  for (const auto& [key, count] : words_.counts) {
    const auto word = symbol_at(key, 0);
    write(one, of_word(word), text_of(word, symbols));
    end_line(one, pairs_.back_off(word_of(word)));
    ++ones;
  }
  for (const auto& [key, count] : pairs_.counts) {
    const auto word = symbol_at(key, 0);
    const auto last = symbol_at(key, 1);
    write(two, of_pair(last, word), text_of(last, symbols),
          text_of(word, symbols));
    end_line(two, triples_.back_off(pair_of(last, word)));
    ++twos;
  }
  for (const auto& [key, count] : triples_.counts) {
    const auto word = symbol_at(key, 0);
    const auto last = symbol_at(key, 1);
    const auto before = symbol_at(key, 2);
    // "<s> <s> word" is the pair.
    if (last == sentence_begin || count < least)
      continue;
    write(three, probability(before, last, word), text_of(before, symbols),
          text_of(last, symbols), text_of(word, symbols));
    three.push_back('\n');
    ++threes;
  }
  return fmt::format("\\data\\\nngram 1={}\nngram 2={}\nngram "
                     "3={}\n\n\\1-grams:\n{}\n\\2-grams:\n{}\n\\3-grams:\n{}\n"
                     "\\end\\\n",
                     ones, twos, threes, fmt::to_string(one),
                     fmt::to_string(two), fmt::to_string(three));
}

} // namespace parlour::adapters::asr
