// Explains why an utterance was understood as it was, for `parlour understand`.
// The lines are described in docs/understanding.md.
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/acts/chain.hpp"
#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/understand/likeness.hpp"
#include "adapters/nlu/understand/trained_model.hpp"

namespace parlour::adapters::nlu {

// Refers to its arguments, which must outlive it.
class Explanation {
public:
  Explanation(const Utterance& utterance, const Spans& spans,
              const Schema& schema)
      : utterance_(utterance), spans_(spans), schema_(schema) {}

  // Tokens, islands, chains and acts, a line each.
  std::vector<std::string> lines(const std::vector<Island>& islands,
                                 const std::vector<Chain>& chains,
                                 const std::vector<BuiltAct>& acts) const;

  // The topics for which the examples speak, with the slots of the most likely
  // one, and sentences of rules that are like it.
  std::vector<std::string> learnt(const TrainedModel& learned,
                                  const Likeness& likeness) const;

private:
  std::string learnt(const TrainedModel& learned) const;
  std::string tokens() const;
  std::string island(const Island& island) const;
  std::string act(const BuiltAct& act) const;
  std::string topic(TopicNumber number) const;

  const Utterance& utterance_;
  const Spans& spans_;
  const Schema& schema_;
};

} // namespace parlour::adapters::nlu
