// How an NLG component turns what the engine wants to say into words without
// knowing the script language: `script` implements this, the composition root
// hands it over (architecture, runtime/base).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

struct Rendering {
  std::optional<std::string> words = {}; // nothing where no phrase applies
  // Of phrases that could not be computed: another was taken in their place.
  std::vector<Error> failures = {};
};

class PhraseEvaluator {
public:
  virtual ~PhraseEvaluator() = default;

  // `say` is a map {act, topic, slot, data, rotation, now}; rotation chooses
  // among the variants that apply, so that equal inputs give equal words.
  // Safe to call from any thread.
  virtual Rendering render(const Value& say) const = 0;
};

} // namespace parlour
