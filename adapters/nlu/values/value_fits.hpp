// ValueFits tells which values each token of an utterance fits, alone or with
// the ones behind it; an implementation detail of ValueIndex.
//
// A common name is a word of hundreds of people. So words are looked up for
// all tokens first, and of the values that fit at one token only, those are
// left out that are much worse there than others of their set.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "adapters/nlu/values/value_index.hpp"

namespace parlour::adapters::nlu {

// How far a match may reach, in tokens.
inline constexpr std::size_t widest_window = 16;
// What a value gains that was said completely. Values whose quality is this
// close to the best one's are candidates, too.
inline constexpr double said_wholly = 0.2;
inline constexpr double equally_good = 0.03;

// Refers to its arguments, which must outlive it.
class ValueFits {
public:
  // A token (or two) that fits a word (or two) of a value.
  struct Fit {
    std::uint32_t value = 0;
    std::uint16_t mask = 0;
    // In tokens.
    std::uint8_t length = 1;
    float similarity = 1;
    // Letter by letter, which may repeat a word: "Tan, T A N".
    bool spelt = false;
  };

  ValueFits(const ValueIndex& index, const Tokens& tokens,
            const std::vector<bool>& plain);

  // By the token at which they begin, sorted by value.
  std::vector<std::vector<Fit>> run();

private:
  using Posting = ValueIndex::Posting;

  // The values of a word that was found.
  struct Found {
    std::span<const Posting> postings;
    std::uint8_t length = 1;
    float similarity = 1;
    bool spelt = false;
    bool of_people = false; // only those
  };

  // The best that fits in one way and is of one set.
  struct Best {
    SetId set = 0;
    std::uint8_t length = 1;
    bool one_word = false;
    double quality = 0;
  };
  // The last one that was asked for is asked for again mostly: the values of a
  // word are sorted by set.
  struct Bests {
    std::vector<Best> all;
    std::size_t last = 0;
  };

  void find();
  void find_at(std::size_t position);
  void find_joined(std::size_t position);
  void find_spelt(std::size_t position);
  void find_said_alike(std::size_t position);
  void look_up(std::size_t position, std::string_view word, bool misspelt,
               std::uint8_t length, bool spelt = false);
  void add(std::size_t position, const ValueIndex::Lists& lists,
           const std::vector<WordIndex::Hit>& hits, std::uint8_t length,
           bool spelt);

  bool takes(const Found& found, const Posting& posting) const;
  void count();
  double quality(const Found& found, const Posting& posting) const;
  Bests bests(const std::vector<Found>& all) const;
  Best& best_of(Bests& bests, const Found& found, const Posting& posting) const;
  std::vector<Fit> fits_at(std::size_t position) const;

  const ValueIndex& index_;
  const Tokens& tokens_;
  const std::vector<bool>& plain_;
  std::vector<std::vector<Found>> found_; // by token
  // By value, how often it fits; 2 and more are 2. Empty: few fit at all.
  std::vector<std::uint8_t> times_;
};

} // namespace parlour::adapters::nlu
