// A word graph as text that PocketSphinx reads (fsg_model_read). Value sets are
// put in: small ones once for each place that goes on differently, large ones
// once. Sentences may follow each other.
#pragma once

#include <map>
#include <string>

#include "adapters/asr/words/word_graph.hpp"

namespace parlour::adapters::asr {

// The defaults are those of the recogniser; tests change them.
struct FsgOptions {
  // The probability that another sentence follows; 0: only one.
  double another = 0.1;
  // Sets with more arcs are put in once, so that a few more sentences can be
  // heard than the graph has: behind a name, all that follows any name.
  std::size_t most_copied = 8;
  // More transitions are not written (is_whole is false then).
  std::size_t most_transitions = 400'000;
};

// The figures are for tests.
struct FsgText {
  std::string text;
  std::size_t states = 0;
  std::size_t transitions = 0;
  bool is_whole = true;
};

// The words are written as `symbols` has them. A graph without sentences gives
// one that hears nothing.
FsgText fsg_text(const WordGraph& graph, const Symbols& symbols,
                 const std::map<Symbol, WordGraph>& sets,
                 const FsgOptions& options = {});

} // namespace parlour::adapters::asr
