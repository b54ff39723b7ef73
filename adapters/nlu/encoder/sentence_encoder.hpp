// SentenceEncoder turns a sentence into numbers that are alike for sentences
// that mean something alike, in whatever words: "could you get me a cab", "I
// need a taxi". It is a small neural network (a transformer of some layers),
// read from a file that tools/sentences makes; everything works without it,
// only with more examples.
//
//  const auto encoder =
//      SentenceEncoder::read("config/platform/sentences.encoder");
//  const auto numbers = (*encoder)->encode("i need a taxi");
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/encoder/dense.hpp"
#include "adapters/nlu/encoder/word_pieces.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::nlu {

// Any number of threads may use it.
class SentenceEncoder {
public:
  // The file: "PARLOURS", the pieces of words, a ByteTable with the numbers of
  // each piece, a count of layers, each layer, and the Dense layer that makes
  // the numbers of the sentence. Errors are of kind File.
  static Expected<std::shared_ptr<const SentenceEncoder>>
  read(const std::filesystem::path& path);

  // A vector of length 1. Takes some milliseconds; of a long text, only the
  // first 128 pieces count. The same text gives the same numbers.
  std::vector<float> encode(std::string_view text) const;

  // How many numbers it makes of a text.
  std::size_t width() const {
    return last_.outputs();
  }
  // A hash of its file.
  std::uint64_t sum() const {
    return sum_;
  }
  // Encoders of the same file are the same.
  bool operator==(const SentenceEncoder& other) const {
    return sum_ == other.sum_;
  }

private:
  // What is learnt of how a row's numbers are spread: each row is brought to a
  // mean of 0 and a deviation of 1, then scaled and moved.
  struct Norm {
    static Norm read(ByteReader& reader, std::size_t width);
    Rows apply(Rows rows) const;

    std::vector<float> scale;
    std::vector<float> moved;
  };

  // Each row first looks at all others (attention), then is worked on alone.
  struct Layer {
    static Layer read(ByteReader& reader, std::size_t width);
    Rows apply(Rows rows) const;
    // What each row gets from the others, of queries, keys and values side by
    // side.
    Rows attend(const Rows& rows) const;

    std::size_t heads = 1;
    Norm norm_of_attention;
    Dense queries_keys_values;
    Dense attended;
    // What goes past the attention; nothing if it passes as it is.
    Dense passing;
    Norm norm_of_work;
    Dense widening;
    Dense narrowing;
  };

  Expected<void> read_parts(std::string_view bytes);
  Rows rows_of(std::string_view text) const;

  WordPieces pieces_;
  ByteTable meanings_; // of pieces
  std::vector<Layer> layers_;
  Dense last_;
  std::uint64_t sum_ = 0; // of the file
};

} // namespace parlour::adapters::nlu
