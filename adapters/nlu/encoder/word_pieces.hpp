// WordPieces cuts a text into pieces that occur often: "unbelievable" into
// "▁un", "believ", "able". Of all ways to cut it, the one whose pieces are
// likeliest together is taken (a unigram language model).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/text/word_index.hpp"
#include "runtime/base/bytes.hpp"

namespace parlour::adapters::nlu {

// Immutable; any number of threads may use it.
class WordPieces {
public:
  // The number of what no piece fits.
  static constexpr std::uint32_t unknown = 0;

  WordPieces() = default;

  // The pieces in the order of their numbers: a count, then for each its text
  // and the logarithm of its frequency (a float). A blank is written "▁".
  static WordPieces read(ByteReader& reader);

  // The numbers of the pieces of a text, at most `most`: the rest is left out.
  // Pieces that nobody knows and that follow each other count as one.
  std::vector<std::uint32_t> cut(std::string_view text, std::size_t most) const;

  std::size_t size() const {
    return scores_.size();
  }

private:
  // How the best cut of the bytes before a place ends.
  struct Step {
    float score = 0;
    std::uint32_t piece = unknown;
    std::size_t begin = 0;
    bool reached = false;
  };

  std::vector<Step> steps(std::string_view text) const;

  TextMap<std::uint32_t> numbers_;
  std::vector<float> scores_; // by number
  std::size_t longest_ = 0;   // bytes
};

} // namespace parlour::adapters::nlu
