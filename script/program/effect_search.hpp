// Finds out which effects a piece of code may perform, itself or through the
// functions that it calls. It does not follow calls by a computed name, which
// may lead anywhere, nor bodies that run later (timers).
#pragma once

#include <functional>
#include <optional>

#include "script/program/host.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// Where an effect was found.
struct EffectFound {
  EffectKind kind = {};
  Position position;      // of the effect
  Position call;          // in the code itself: the call that leads there
  bool is_called = false; // false: the code itself performs it
};

// The nearest effect for which `wanted` is true, in calls; nothing if there is
// none.
std::optional<EffectFound>
find_effect(const Program& program, CodeId code,
            const std::function<bool(EffectKind)>& wanted);

} // namespace parlour::script
