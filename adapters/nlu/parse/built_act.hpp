// BuiltAct is an act as understanding makes it: with the tokens that it comes
// from, before it becomes a value.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/nlu/parse/islands.hpp"

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
  // The share of its words.
  double understood = 0;
  // That, plus the bonus for being expected; it may exceed 1.
  double score = 0;
};

} // namespace parlour::adapters::nlu
