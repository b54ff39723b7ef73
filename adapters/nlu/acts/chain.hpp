// Finds the best sequence of islands through an utterance, without overlap, for
// each topic in which it may end.
#pragma once

#include <vector>

#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

struct ChainLink {
  const Island* island = nullptr;
  TopicNumber topic = no_topic;
};

// A sequence of islands, from left to right.
struct Chain {
  // The share of the utterance that its islands cover, by weight.
  double coverage(const Utterance& utterance) const;

  std::vector<ChainLink> links; // in order
  double score = 0;
};

// Returns the best chain for each last topic; the best first. There is at least
// one, which may be empty. `size` is the number of tokens. The chains refer to
// the islands.
std::vector<Chain> best_chains(const std::vector<Island>& islands,
                               std::size_t size, const Context& context);

} // namespace parlour::adapters::nlu
