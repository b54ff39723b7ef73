// Says why an utterance was understood as it was, for `parlour understand`.
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/parse/acts.hpp"
#include "adapters/nlu/understand/learned.hpp"

namespace parlour::adapters::nlu {

class Explanation {
public:
  Explanation(const Utterance& utterance, const Spans& spans,
              const Schema& schema)
      : utterance_(utterance), spans_(spans), schema_(schema) {}

  std::vector<std::string> lines(const std::vector<Island>& islands,
                                 const std::vector<Chain>& chains,
                                 const std::vector<BuiltAct>& acts) const;

  // Which topics the examples speak for, and the slots of the likeliest.
  std::vector<std::string> learnt(const Learned& learned) const;

private:
  std::string tokens() const;
  std::string island(const Island& island) const;
  std::string act(const BuiltAct& act) const;
  std::string topic(TopicNumber number) const;

  const Utterance& utterance_;
  const Spans& spans_;
  const Schema& schema_;
};

} // namespace parlour::adapters::nlu
