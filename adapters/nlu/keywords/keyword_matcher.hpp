// KeywordMatcher turns a text into acts by keyword rules. Each topic of which a
// keyword is said gives one act, in the order of the text. A generic act counts
// only if no topic was said. Without a keyword, values are taken to be about
// the topic that was asked about, or else the current one, or else the resting
// one.
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/keywords/keyword_rules.hpp"
#include "adapters/nlu/parse/context.hpp"

namespace parlour::adapters::nlu {

// Immutable; any number of threads may use it.
class KeywordMatcher {
public:
  explicit KeywordMatcher(KeywordRules rules) : rules_(std::move(rules)) {}

  // The acts, as FrameInfo carries them (runtime/message/understanding.hpp).
  // `context` is the map that comes with DoNLU. Empty if nothing was
  // understood.
  std::vector<Value> understand(const std::string& text,
                                const Value& context) const;

private:
  KeywordRules rules_;
};

} // namespace parlour::adapters::nlu
