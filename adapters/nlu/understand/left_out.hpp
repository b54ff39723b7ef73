// Reads each example of an application as if it were not among them. What
// people say who have not read the examples is understood about as well
// (docs/understanding.md, "Are the examples enough?").
//
//  const auto readings = read_left_out(model, columns, options);
//  // readings[0]: {topic: "Taxi", example: "a cab to [Bedok](To)",
//  //               taken_for: "Bus", score: 0.7, like: "a bus to …"}
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/understand/nlu_engine.hpp"

namespace parlour::adapters::nlu {

struct LeftOutExample {
  std::string topic;
  std::string example; // with its marks
  // Whether another example of the topic differs from it in values and small
  // words only.
  bool repeats = false;
  // Which topic it was taken for; empty: none.
  std::string taken_for = {};
  double score = 0;
  // Whether its own topic was taken, or came close.
  bool own = false;
  // The example of `taken_for`, if that is another topic, which has most words
  // in common with it; empty: none has any.
  std::string like = {};
  // Its words with a meaning of their own that no other example of the topic
  // has.
  std::vector<std::string> lone = {};
};

// Examples that say the same are left out together, a few others with them, so
// the engine is built a few times: as many seconds as it takes to start.
// Topics that are only spoken about while they go on are left out. Empty if the
// engine cannot be built. A context is not given.
std::vector<LeftOutExample> read_left_out(const UnderstandingModel& model,
                                          const ColumnReader& columns,
                                          const NluEngine::Options& options);

} // namespace parlour::adapters::nlu
