// The best way to go from island to island through an utterance, without
// overlap, one for each topic that it may end in.
#pragma once

#include <vector>

#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

struct ChainLink {
  const Island* island = nullptr;
  TopicNumber topic = no_topic;
};

struct Chain {
  std::vector<ChainLink> links; // in order
  double score = 0;
};

// Best first. `size` is the utterance's number of tokens.
std::vector<Chain> best_chains(const std::vector<Island>& islands,
                               std::size_t size, const Context& context);

} // namespace parlour::adapters::nlu
