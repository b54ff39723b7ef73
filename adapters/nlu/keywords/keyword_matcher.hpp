// Text to acts by keyword rules.
//
// Each topic of which a keyword is said gives one act, in the order of the
// text; a generic act counts where no topic was said. Without any, values of
// the topic that was asked about, else of the current one, else of the one that
// rests, go on with it.
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/keywords/keyword_rules.hpp"
#include "adapters/nlu/parse/context.hpp"

namespace parlour::adapters::nlu {

// Safe to use from several threads at once.
class KeywordMatcher {
public:
  explicit KeywordMatcher(KeywordRules rules) : rules_(std::move(rules)) {}

  // As FrameInfo has them (runtime/base/understanding.hpp), and the context
  // that comes with DoNLU. None: not understood.
  std::vector<Value> understand(const std::string& text,
                                const Value& context) const;

private:
  KeywordRules rules_;
};

} // namespace parlour::adapters::nlu
