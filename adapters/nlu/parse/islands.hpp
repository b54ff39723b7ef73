// An island: what a part of the utterance says, read from a match.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/nlu/parse/context.hpp"
#include "adapters/nlu/parse/matcher.hpp"

namespace parlour::adapters::nlu {

// One slot's value.
struct Fill {
  std::string slot;
  TopicNumber topic = no_topic;      // where it can only be of this one
  std::optional<std::uint32_t> span; // else `literal`, else the words
  std::optional<Value> literal;
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
};

struct Island {
  const RuleInfo* rule = nullptr;
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
  double score = 0;
  double covered = 0;
  bool weak = false;
  bool asked = false;              // fills the slot that was asked for
  bool denies = false;             // what follows is not wanted
  std::string act;                 // "" where the rule says none
  std::vector<TopicNumber> topics; // that it may be about
  std::vector<Fill> fills;

  // "no", "sorry, I mean": corrects what stands before or comes after.
  bool is_marker() const {
    return topics.empty() && (act == "deny" || act == "correct");
  }
  bool is_content() const {
    return !topics.empty();
  }
  const Fill* find(std::string_view slot) const;
};

// Reads all matches that the context allows; those that make no sense (slots
// of different topics) are left out.
std::vector<Island> read_islands(const std::vector<Match>& matches,
                                 const std::vector<Trace>& traces,
                                 const Spans& spans, const Automaton& automaton,
                                 const Schema& schema, const Context& context);

} // namespace parlour::adapters::nlu
