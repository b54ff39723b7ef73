// How an NLG component turns what the engine wants to say into words without
// knowing the script language: `script` implements this, the composition root
// hands it over (architecture, runtime/base).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

class PhraseEvaluator {
public:
  virtual ~PhraseEvaluator() = default;

  // `say` is a map {act, topic, slot, data, rotation, now}; rotation chooses
  // among the variants that apply, so that equal inputs give equal words.
  // Nothing where no phrase applies. Safe to call from any thread.
  virtual std::optional<std::string> render(const Value& say) const = 0;
};

} // namespace parlour
