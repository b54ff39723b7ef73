// LostWait: a script waits for an outcome that will not come any more, as the
// conversation goes on with another port. What it is given instead. Plain data.
#pragma once

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"
#include "script/dialogue/agenda/step.hpp"

namespace parlour::dialogue {

struct LostWait {
  WaitId wait = 0;
  Expected<Value> outcome;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(wait, outcome);
  }
};

// Nothing is silently done twice: what was asked for may have been carried out.
inline LostWait in_doubt(WaitId wait) {
  return {wait, fail(ErrorKind::in_doubt,
                     "the session was interrupted before the outcome came: "
                     "whether it was done is not known")};
}

} // namespace parlour::dialogue
