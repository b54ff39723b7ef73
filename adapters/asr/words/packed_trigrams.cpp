#include "adapters/asr/words/packed_trigrams.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "adapters/nlu/text/characters.hpp"

namespace parlour::adapters::asr {

namespace {

// As the program compares words: without accents, too.
std::string plain(std::string_view text) {
  std::string made;
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, length] = nlu::character_at(text, at);
    if (nlu::is_word_character(code))
      nlu::append_folded(made, code);
    at += length;
  }
  return made;
}

class Writer {
public:
  explicit Writer(const Trigrams& model) : model_(model) {}

  std::string write(const Symbols& symbols) {
    const auto texts = texts_of(symbols);
    const auto count = [](const Trigrams::Order& order) {
      return static_cast<std::uint32_t>(order.rows.size());
    };
    for (const auto number :
         {count(model_.words()), count(model_.pairs()), count(model_.triples()),
          static_cast<std::uint32_t>(texts.size())})
      add(number);
    bytes_ += texts;
    add_logarithms(model_.words(), &Trigrams::Row::probability);
    add_logarithms(model_.words(), &Trigrams::Row::left);
    add_below(model_.pairs());
    add_logarithms(model_.pairs(), &Trigrams::Row::left);
    add_below(model_.triples());
    return std::move(bytes_);
  }

private:
  std::string texts_of(const Symbols& symbols) const {
    std::string texts;
    for (const auto& row : model_.words().rows) {
      texts += word_text(row.word, symbols);
      texts += '\n';
    }
    while (texts.size() % sizeof(std::uint32_t) != 0)
      texts += '\n';
    return texts;
  }

  void add(std::uint32_t number) {
    for (std::size_t byte = 0; byte < sizeof number; ++byte)
      bytes_ += static_cast<char>(number >> 8 * byte & 0xFF);
  }

  void add_below(const Trigrams::Order& order) {
    for (const auto begin : order.begins)
      add(begin);
    for (const auto& row : order.rows)
      add(static_cast<std::uint32_t>(model_.word_at(row.word)));
    add_logarithms(order, &Trigrams::Row::probability);
  }

  void add_logarithms(const Trigrams::Order& order,
                      double Trigrams::Row::*probability) {
    for (const auto& row : order.rows)
      add(std::bit_cast<std::uint32_t>(
          static_cast<float>(std::log(row.*probability))));
  }

  const Trigrams& model_;
  std::string bytes_;
};

} // namespace

std::string packed(const TrigramCounts& counts, const Symbols& symbols,
                   double least) {
  Symbols plain_symbols;
  std::vector<Symbol> renamed;
  for (Symbol symbol = 0; symbol < symbols.size(); ++symbol)
    renamed.push_back(plain_symbols.word(plain(symbols.text(symbol))));
  const Trigrams model(
      counts.renamed([&](Symbol symbol) { return renamed[symbol]; }), least);
  return Writer(model).write(plain_symbols);
}

} // namespace parlour::adapters::asr
