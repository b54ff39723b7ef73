// What was understood of a text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

struct Understanding {
  // The acts, as engine rule 5 wants them, in the order of the utterance; empty
  // if nothing was understood well enough. In addition to the keys of
  // runtime/message/understanding.hpp, a slot has `unmatched` true if its words
  // stand for a value that the set does not have.
  List acts;
  // Whether what was learnt took the place of what rules found.
  bool is_learnt = false;
  // Of the best act.
  double score = 0;
  // The share of the words that grammars and values account for, by weight.
  double coverage = 0;
  // Tokens, islands and scores, a line each; only if wanted.
  std::vector<std::string> explanation;
  // The number of arcs that were tried, for tests of the bound.
  std::size_t work = 0;
};

} // namespace parlour::adapters::nlu
