// EffectSearch: which effects a piece of code leads to, by itself or by the
// functions that it calls. A call whose name is computed may lead anywhere and
// is not followed; nor is what runs later or elsewhere (a timer's body).
#pragma once

#include <functional>
#include <optional>

#include "script/program/host.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

struct EffectFound {
  EffectKind kind = {};
  Position position;      // of the effect
  Position call;          // in the code itself: of the call that leads there
  bool is_called = false; // else it is the code's own
};

// The nearest effect that is `wanted`; nothing where there is none.
std::optional<EffectFound>
find_effect(const Program& program, CodeId code,
            const std::function<bool(EffectKind)>& wanted);

} // namespace parlour::script
