// give(): which part takes a step is said by its take() alone.
#pragma once

#include <utility>

namespace parlour::dialogue {

// To the first of the parts that takes steps of this kind. Where none does, it
// does not compile: a new kind in steps.def needs a taker. The order of the
// parts matters only if two of them take the same kind.
template <class Kind, class Part, class... Parts>
void give(Kind&& step, Part& part, Parts&... others) {
  if constexpr (requires { part.take(std::forward<Kind>(step)); })
    part.take(std::forward<Kind>(step));
  else
    give(std::forward<Kind>(step), others...);
}

} // namespace parlour::dialogue
