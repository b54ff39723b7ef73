// From a chain of islands to acts (engine rule 5, "Acts"): islands of one topic
// become one act, corrections are applied, what does not count is left out.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/chain.hpp"

namespace parlour::adapters::nlu {

struct BuiltAct {
  std::string act;
  TopicNumber topic = no_topic;
  std::vector<Fill> fills; // one for each slot
  bool elliptical = false;
  bool negated = false;    // a "deny" of what was not to be done
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
  double score = 0; // share understood and bonus; may be above 1
};

// `threshold`: acts with a lower score are left out.
std::vector<BuiltAct> build_acts(const Chain& chain, const Utterance& utterance,
                                 const Schema& schema, const Context& context,
                                 double threshold);

// As the frame list's entry (runtime/base/understanding.hpp).
Map act_value(const BuiltAct& act, const Utterance& utterance,
              const Spans& spans, const Schema& schema);

} // namespace parlour::adapters::nlu
