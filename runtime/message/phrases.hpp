// PhraseEvaluator: turns what the engine wants to say into words, by the
// phrases of the application. script/run implements it; an NLG component uses
// it and so needs no knowledge of the script language. The composition root
// connects the two.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

// The outcome for one thing to say.
struct Rendering {
  std::optional<std::string> words = {}; // nothing if no phrase applies
  // Errors of phrases that could not be computed; another was used instead.
  std::vector<Error> failures = {};
};

class PhraseEvaluator {
public:
  virtual ~PhraseEvaluator() = default;

  // `say` is a map {act, topic, slot, data, rotation, now}. `rotation` selects
  // among the variants that apply, so equal inputs give equal words. Safe to
  // call from any thread.
  virtual Rendering render(const Value& say) const = 0;
};

} // namespace parlour
