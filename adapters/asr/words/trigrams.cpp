#include "adapters/asr/words/trigrams.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace parlour::adapters::asr {

namespace {

// No word is a context of a pair.
constexpr Symbol nothing = 0xFFFFD;

std::string text_of(Symbol symbol, const Symbols& symbols) {
  return symbol == Trigrams::begin ? "<s>"
         : symbol == Trigrams::end ? "</s>"
                                   : symbols.text(symbol);
}

double decimal_logarithm(double probability) {
  return probability > 0 ? std::log10(probability) : -99;
}

} // namespace

// Witten and Bell: a context that was followed by many different words is
// believed less, as others may follow it, too.
double Trigrams::Context::trust() const {
  return count > 0 ? count / (count + static_cast<double>(words.size())) : 0;
}

Trigrams::Key Trigrams::key(Symbol before, Symbol last) {
  return (static_cast<Key>(before) << 32) | last;
}

// Each word is counted in three contexts, and the end of the sentence as a
// word.
void Trigrams::add(const Sentence& sentence, double weight) {
  auto before = begin;
  auto last = begin;
  auto count = [&](Symbol word) {
    for (auto* context :
         {&words_, &pairs_[key(nothing, last)], &triples_[key(before, last)]}) {
      context->count += weight;
      context->words[word] += weight;
    }
    before = last;
    last = word;
  };
  for (const auto word : sentence)
    count(word);
  count(end);
}

const Trigrams::Context* Trigrams::find(Key key) const {
  const auto& contexts = (key >> 32) == nothing ? pairs_ : triples_;
  const auto found = contexts.find(key);
  return found == contexts.end() ? nullptr : &found->second;
}

// `rest` is the probability in the shorter context.
double Trigrams::interpolated(const Context* context, Symbol word,
                              double rest) const {
  if (!context)
    return rest;
  const auto found = context->words.find(word);
  const auto own =
      found == context->words.end() ? 0 : found->second / context->count;
  const auto trust = context->trust();
  return trust * own + (1 - trust) * rest;
}

// The shortest context has a shorter one still: all words equally probable.
double Trigrams::of_word(Symbol word) const {
  const auto size =
      static_cast<double>(std::max<std::size_t>(1, words_.words.size()));
  return interpolated(&words_, word, 1 / size);
}

double Trigrams::of_pair(Symbol last, Symbol word) const {
  return interpolated(find(key(nothing, last)), word, of_word(word));
}

double Trigrams::probability(Symbol before, Symbol last, Symbol word) const {
  return interpolated(find(key(before, last)), word, of_pair(last, word));
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
  auto back_off = [&](Key context) {
    const auto* found = find(context);
    return found ? decimal_logarithm(1 - found->trust()) : 0;
  };
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
                 back_off(key(nothing, begin)));
  for (const auto& [word, count] : words_.words) {
    write(one, of_word(word), text_of(word, symbols));
    end_line(one, back_off(key(nothing, word)));
    ++ones;
  }
  for (const auto& [context, found] : pairs_)
    for (const auto& [word, count] : found.words) {
      const auto last = static_cast<Symbol>(context);
      write(two, of_pair(last, word), text_of(last, symbols),
            text_of(word, symbols));
      end_line(two, back_off(key(last, word)));
      ++twos;
    }
  for (const auto& [context, found] : triples_)
    for (const auto& [word, count] : found.words) {
      const auto before = static_cast<Symbol>(context >> 32);
      const auto last = static_cast<Symbol>(context);
      // "<s> <s> word" is the pair.
      if (last == begin || count < least)
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
