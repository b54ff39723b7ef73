// One search of an utterance for values; an implementation detail of
// ValueIndex.
#pragma once

#include <span>

#include "adapters/nlu/values/value_index.hpp"

namespace parlour::adapters::nlu {

class ValueSearch {
public:
  ValueSearch(const ValueIndex& index, const Tokens& tokens,
              const std::vector<bool>& plain);

  std::vector<ValueMatch> run();

private:
  // A value, and how well a word of the utterance (or two) fits one of its.
  struct Fit {
    std::uint32_t value = 0;
    std::uint16_t mask = 0;
    std::uint8_t length = 1; // tokens
    float similarity = 1;
  };

  // A value of which some words were found since the window began.
  struct Partial {
    std::uint32_t value = 0;
    std::uint16_t mask = 0;
    std::uint8_t count = 0; // tokens used
    float similarity = 0;   // their sum
    bool own_word = false;  // one of them means nothing else
  };

  using Partials = std::vector<Partial>;

  void collect_fits();
  void add_fits(std::size_t position);
  void add_hit(std::size_t position, const WordIndex::Hit& hit,
               std::uint8_t length);

  void search_from(std::size_t begin);
  void extend(const Partials& partials, std::size_t begin, std::size_t position,
              std::size_t target);
  bool may_skip(std::size_t position) const;
  void tidy(Partials& partials) const;

  void emit(std::size_t begin, std::size_t end, const Partials& partials);
  void emit_set(std::size_t begin, std::size_t end,
                std::span<const Partial> partials);
  double recall(const Partial& partial) const;
  bool whole(const Partial& partial) const;
  double quality(const Partial& partial) const;
  std::size_t strangers(std::size_t begin, std::size_t end) const;

  const ValueIndex& index_;
  const Tokens& tokens_;
  const std::vector<bool>& plain_;
  std::vector<std::vector<Fit>> fits_; // by the token they begin at
  std::vector<Partials> ends_;         // by the token behind, of one window
  std::vector<ValueMatch> matches_;
};

} // namespace parlour::adapters::nlu
