// A domain model as MoonshineASR's program reads it (tools/agents/moonshine):
// the same numbers as in the ARPA format, but nothing to be parsed, as that
// took the program longer than all else that a changed table costs.
#pragma once

#include <string>

#include "adapters/asr/words/trigrams.hpp"

namespace parlour::adapters::asr {

// Little-endian numbers of 32 bits, one array after the other:
//
//   4   how many words, pairs, triples; the bytes of the words' texts
//       texts, one a line, filled up with line ends to whole numbers;
//       "<s>" and "</s>" where a sentence begins and ends
//   2   of each word: its probability; what is left behind it
//       where the pairs below each word begin; the end
//   3   of each pair: the index of its last word; probability; what is left
//       where the triples below each pair begin; the end
//   2   of each triple: the index of its last word; probability
//
// Of probabilities and what is left there are natural logarithms. Words are
// without capitals, accents and punctuation: those that become the same are
// one.
std::string packed(const TrigramCounts& counts, const Symbols& symbols,
                   double least);

} // namespace parlour::adapters::asr
