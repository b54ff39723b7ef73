// WaitOutcome: a script's wait is over: what it is given for it. Plain data.
// Parts that keep waits (requests, queries, sockets) return it; the
// conversation hands it on (ConversationImplementation::end_wait), so none of
// them needs the ActivationRunner.
#pragma once

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"
#include "script/dialogue/agenda/step.hpp"

namespace parlour::dialogue {

// The activation that waits so goes on with this value, or with this error,
// which its <catch> may take.
struct WaitOutcome {
  WaitId wait = 0;
  Expected<Value> outcome;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(wait, outcome);
  }
};

// The conversation goes on with another port, and the outcome will not come any
// more. Nothing is silently done twice: what was asked for may have been
// carried out.
inline WaitOutcome in_doubt(WaitId wait) {
  return {wait, fail(ErrorKind::in_doubt,
                     "the session was interrupted before the outcome came: "
                     "whether it was done is not known")};
}

} // namespace parlour::dialogue
