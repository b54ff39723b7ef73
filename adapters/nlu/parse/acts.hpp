// Turns a chain of islands into acts (engine rule 5, "Acts"): islands of one
// topic become one act, corrections are applied, and acts that do not count are
// removed.
//
//  "a taxi to the airport, no, to the harbour"  inform Taxi {To: harbour}
//  "no, to the harbour"                         correct Taxi {To: harbour}
//  "hello, a taxi please"                       inform Taxi {}
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
  // One for each slot.
  std::vector<Fill> fills;
  bool elliptical = false;
  // A value alone, without words that lead in ("and …").
  bool is_aside = false;
  // A rule says which act it is, so it has a sentence of its own.
  bool is_declared = false;
  // A "deny" that stands for a negated order.
  bool negated = false;
  // Tokens [begin, end).
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  // The share of its words that was understood, plus the bonus for being
  // expected; it may exceed 1.
  double score = 0;
};

// Returns the acts in the order of the utterance. Acts with a score below
// `threshold` are left out.
std::vector<BuiltAct> build_acts(const Chain& chain, const Utterance& utterance,
                                 const Schema& schema, const Context& context,
                                 double threshold);

} // namespace parlour::adapters::nlu
