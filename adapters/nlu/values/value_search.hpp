// ValueSearch is one search of an utterance for values; an implementation
// detail of ValueIndex.
//
// For each token at which a value may begin, the search opens a window and
// extends partial matches to the right, token by token. A partial match is a
// value and a mask of its words that were found, so word order does not matter.
// At each end of the window the partial matches of a set compete, and the best
// become a match.
#pragma once

#include <span>

#include "adapters/nlu/values/value_fits.hpp"

namespace parlour::adapters::nlu {

// Refers to its arguments, which must outlive it.
class ValueSearch {
public:
  ValueSearch(const ValueIndex& index, const Tokens& tokens,
              const std::vector<bool>& plain);

  std::vector<ValueMatch> run();

private:
  using Fit = ValueFits::Fit;

  // A value of which some words were found since the window began.
  struct Partial {
    std::uint32_t value = 0;
    std::uint16_t mask = 0;
    // The tokens used, and the sum of their similarities.
    std::uint8_t count = 0;
    float similarity = 0;
    // The product of the similarities.
    float fidelity = 1;
    // One of the tokens has no other meaning.
    bool own_word = false;
  };

  using Partials = std::vector<Partial>;

  void search_from(std::size_t begin);
  void extend(const Partials& partials, std::size_t begin,
              std::size_t position);
  void extend_by(const Partial& partial, const Fit& fit, std::size_t position);
  bool may_skip(std::size_t position) const;
  void tidy(Partials& partials) const;

  void emit(std::size_t begin, std::size_t end, const Partials& partials);
  void emit_set(std::size_t begin, std::size_t end,
                std::span<const Partial> partials);
  double recall(const Partial& partial) const;
  bool whole(const Partial& partial) const {
    return (index_.values_[partial.value].heavy & ~partial.mask) == 0;
  }
  bool is_plain_part(const Partial& partial, std::size_t begin,
                     std::size_t end) const;
  double likeness(const Partial& partial) const;
  double quality(const Partial& partial) const;
  double confidence(const Partial& partial, std::size_t begin,
                    std::size_t end) const;
  bool of_people(const Partial& partial) const;
  bool is_stranger(std::size_t position, SetId set) const;
  std::size_t strangers(std::size_t begin, std::size_t end, SetId set) const;

  const ValueIndex& index_;
  const Tokens& tokens_;
  const std::vector<bool>& plain_;
  std::vector<std::vector<Fit>> fits_; // by token
  // By the token behind them; of the current window only.
  std::vector<Partials> ends_;
  std::vector<ValueMatch> matches_;
};

} // namespace parlour::adapters::nlu
