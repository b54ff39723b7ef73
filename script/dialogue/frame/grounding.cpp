#include "script/dialogue/frame/grounding.hpp"

#include "runtime/base/defaults.hpp"

namespace parlour::dialogue {

namespace {

// The limits of engine rule 5.5: 0.4, 0.7 and 0.9. An understanding that tells
// no confidence is believed, and its values are echoed.
Grounding by_confidence(const Value& confidence) {
  if (confidence.is_unknown())
    return Grounding::implicitly;
  auto sure = confidence.number_or(0);
  if (sure < defaults::reject_below)
    return Grounding::reject;
  if (sure < defaults::confirm_below)
    return Grounding::explicitly;
  return sure < defaults::mark_below ? Grounding::implicitly
                                     : Grounding::accept;
}

} // namespace

bool is_certain_confidence(const Value& confidence) {
  return by_confidence(confidence) == Grounding::accept;
}

Grounding ground(script::ConfirmPolicy policy, const Value& confidence) {
  switch (policy) {
  case script::ConfirmPolicy::explicitly:
    return Grounding::explicitly;
  case script::ConfirmPolicy::implicitly:
    return Grounding::implicitly;
  case script::ConfirmPolicy::never:
    return Grounding::accept;
  case script::ConfirmPolicy::automatic:
    break;
  }
  return by_confidence(confidence);
}

} // namespace parlour::dialogue
