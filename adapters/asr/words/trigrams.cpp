#include "adapters/asr/words/trigrams.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::asr {

namespace {

constexpr unsigned bits = 20; // of a symbol

using Counted = TrigramCounts::Counted;
using Row = Trigrams::Row;
using Order = Trigrams::Order;

Symbol symbol_at(std::uint64_t key, unsigned place) {
  return static_cast<Symbol>(key >> place * bits) & ((1U << bits) - 1);
}

// Sorted, and each key once.
std::vector<Counted> united(std::vector<Counted> counted) {
  std::ranges::sort(counted, {}, &Counted::key);
  std::vector<Counted> made;
  for (const auto& one : counted)
    if (made.empty() || made.back().key != one.key)
      made.push_back(one);
    else
      made.back().times += one.times;
  return made;
}

// Each row's context is what its key has before its last symbol. Rows of
// contexts that are not above are left out.
Order order_of(const std::vector<Counted>& counted,
               const std::vector<Counted>& above) {
  Order made;
  auto one = counted.begin();
  for (const auto& context : above) {
    made.begins.push_back(static_cast<std::uint32_t>(made.rows.size()));
    while (one != counted.end() && one->key >> bits < context.key)
      ++one;
    for (; one != counted.end() && one->key >> bits == context.key; ++one)
      made.rows.push_back({symbol_at(one->key, 0), one->times});
  }
  made.begins.push_back(static_cast<std::uint32_t>(made.rows.size()));
  return made;
}

// The row of a word; null if it has none.
const Row* find(std::span<const Row> rows, Symbol word) {
  const auto found = std::ranges::lower_bound(rows, word, {}, &Row::word);
  return found == rows.end() || found->word != word ? nullptr : &*found;
}

// Witten and Bell: a context that was followed by many different words is
// believed less, as others may follow it, too. Returns what is left for them.
// `shorter`: the probability of a word in the shorter context.
template <typename Shorter>
double weigh_rows(std::span<Row> rows, const Shorter& shorter) {
  double times = 0;
  for (const auto& row : rows)
    times += row.times;
  if (times <= 0)
    return 1;
  const auto trust = times / (times + static_cast<double>(rows.size()));
  for (auto& row : rows)
    row.probability =
        trust * row.times / times + (1 - trust) * shorter(row.word);
  return 1 - trust;
}

double decimal_logarithm(double probability) {
  return probability > 0 ? std::log10(probability) : -99;
}

} // namespace

std::uint64_t TrigramCounts::key(Symbol before, Symbol last, Symbol word) {
  return (static_cast<std::uint64_t>(before) << bits | last) << bits | word;
}

void TrigramCounts::add(const Sentence& sentence, double weight) {
  auto before = sentence_begin;
  auto last = sentence_begin;
  for (const auto word : sentence) {
    said_.push_back({key(before, last, word), weight});
    before = std::exchange(last, word);
  }
  said_.push_back({key(before, last, sentence_end), weight});
}

void TrigramCounts::unite() {
  said_ = united(std::move(said_));
}

std::vector<Counted> TrigramCounts::triples() const {
  return united(said_);
}

TrigramCounts
TrigramCounts::renamed(const std::function<Symbol(Symbol)>& name) const {
  const auto renamed = [&](Symbol symbol) {
    return symbol >= sentence_end ? symbol : name(symbol);
  };
  TrigramCounts made;
  for (const auto& [triple, times] : said_)
    made.said_.push_back(
        {key(renamed(symbol_at(triple, 2)), renamed(symbol_at(triple, 1)),
             renamed(symbol_at(triple, 0))),
         times});
  return made;
}

// -- the tree -----------------------------------------------------------------

std::span<const Row> Order::below(std::size_t above) const {
  return std::span(rows).subspan(begins[above],
                                 begins[above + 1] - begins[above]);
}

// Nothing is above what begins a sentence: such triples are pairs.
Trigrams::Trigrams(const TrigramCounts& counts, double least) {
  const auto triples = counts.triples();
  std::vector<Counted> pairs;
  std::vector<Counted> words{{sentence_begin, 0}};
  for (const auto& [key, times] : triples) {
    pairs.push_back({key & ((std::uint64_t{1} << 2 * bits) - 1), times});
    words.push_back({symbol_at(key, 0), times});
  }
  words = united(std::move(words));
  pairs = united(std::move(pairs));
  words_ = order_of(words, {{}});
  pairs_ = order_of(pairs, words);
  triples_ = order_of(triples, pairs);
  weigh();
  leave_out(least);
}

// The shortest context has a shorter one still: all words equally probable.
void Trigrams::weigh() {
  const auto rows_below = [](Order& order, std::size_t above) {
    return std::span(order.rows)
        .subspan(order.begins[above], order.below(above).size());
  };
  const auto spoken = words_.rows.size() - 1;
  weigh_rows(std::span(words_.rows).first(spoken),
             [&](Symbol) { return 1 / static_cast<double>(spoken); });
  for (std::size_t i = 0; i < words_.rows.size(); ++i)
    words_.rows[i].left = weigh_rows(
        rows_below(pairs_, i), [&](Symbol word) { return of_word(word); });
  for (std::size_t i = 0; i < pairs_.rows.size(); ++i) {
    const auto shorter = pairs_.below(word_at(pairs_.rows[i].word));
    pairs_.rows[i].left = weigh_rows(rows_below(triples_, i), [&](Symbol word) {
      return find(shorter, word)->probability;
    });
  }
}

void Trigrams::leave_out(double least) {
  Order kept;
  for (std::size_t i = 0; i < pairs_.rows.size(); ++i) {
    kept.begins.push_back(static_cast<std::uint32_t>(kept.rows.size()));
    std::ranges::copy_if(triples_.below(i), std::back_inserter(kept.rows),
                         [&](const Row& row) { return row.times >= least; });
  }
  kept.begins.push_back(static_cast<std::uint32_t>(kept.rows.size()));
  triples_ = std::move(kept);
}

std::size_t Trigrams::word_at(Symbol word) const {
  const auto* const row = find(words_.rows, word);
  return row ? static_cast<std::size_t>(row - words_.rows.data())
             : words_.rows.size();
}

double Trigrams::of_word(Symbol word) const {
  const auto* const row = find(words_.rows, word);
  return row ? row->probability : 0;
}

double Trigrams::of_pair(Symbol last, Symbol word) const {
  const auto context = word_at(last);
  if (context == words_.rows.size())
    return of_word(word);
  const auto* const row = find(pairs_.below(context), word);
  return row ? row->probability : words_.rows[context].left * of_word(word);
}

double Trigrams::probability(Symbol before, Symbol last, Symbol word) const {
  const auto context = word_at(before);
  if (context == words_.rows.size())
    return of_pair(last, word);
  const auto* const pair = find(pairs_.below(context), last);
  if (!pair)
    return of_pair(last, word);
  const auto index = static_cast<std::size_t>(pair - pairs_.rows.data());
  const auto* const row = find(triples_.below(index), word);
  return row ? row->probability : pair->left * of_pair(last, word);
}

// -- the ARPA format ----------------------------------------------------------

std::string word_text(Symbol symbol, const Symbols& symbols) {
  return symbol == sentence_begin ? "<s>"
         : symbol == sentence_end ? "</s>"
                                  : symbols.text(symbol);
}

// A line of the file is the logarithm of a probability, the words, and the
// logarithm of what is left behind them: "-1.2041 coffee shop -0.3010".
// For a triple that is not there, the reader multiplies the probability of the
// pair by what is left.
std::string Trigrams::arpa(const Symbols& symbols) const {
  std::vector<std::string> texts;
  for (const auto& row : words_.rows)
    texts.push_back(word_text(row.word, symbols));
  fmt::memory_buffer text;
  auto to = std::back_inserter(text);
  fmt::format_to(to, "\\data\\\nngram 1={}\nngram 2={}\nngram 3={}\n",
                 words_.rows.size(), pairs_.rows.size(), triples_.rows.size());
  fmt::format_to(to, "\n\\1-grams:\n");
  for (std::size_t i = 0; i < texts.size(); ++i)
    fmt::format_to(to, "{:.4f} {} {:.4f}\n",
                   decimal_logarithm(words_.rows[i].probability), texts[i],
                   decimal_logarithm(words_.rows[i].left));
  fmt::format_to(to, "\n\\2-grams:\n");
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (const auto& row : pairs_.below(i))
      fmt::format_to(to, "{:.4f} {} {} {:.4f}\n",
                     decimal_logarithm(row.probability), texts[i],
                     texts[word_at(row.word)], decimal_logarithm(row.left));
  fmt::format_to(to, "\n\\3-grams:\n");
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (auto pair = pairs_.begins[i]; pair < pairs_.begins[i + 1]; ++pair)
      for (const auto& row : triples_.below(pair))
        fmt::format_to(to, "{:.4f} {} {} {}\n",
                       decimal_logarithm(row.probability), texts[i],
                       texts[word_at(pairs_.rows[pair].word)],
                       texts[word_at(row.word)]);
  fmt::format_to(to, "\n\\end\\\n");
  return fmt::to_string(text);
}

} // namespace parlour::adapters::asr
