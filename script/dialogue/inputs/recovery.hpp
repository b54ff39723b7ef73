// Recovery: brings a session back from its history, as it was when its last
// input had been taken (engine rule 7.11).
#pragma once

#include <memory>

#include "runtime/message/phrases.hpp"
#include "script/dialogue/inputs/replay.hpp"
#include "script/dialogue/inputs/saved_session.hpp"
#include "script/dialogue/inputs/session_history.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// The session where its history begins; an error, of kind File, where the state
// is damaged or of another program.
Expected<std::unique_ptr<Replay>>
replay_of(const std::shared_ptr<const script::Program>& program,
          const std::shared_ptr<const PhraseEvaluator>& phrases,
          const SessionHistory& history);

// Null where the session has ended. Errors of kind File: its records are
// damaged or of another program, or repeating it leads elsewhere than it did.
Expected<std::unique_ptr<SavedSession>>
recover(const std::shared_ptr<const script::Program>& program,
        const std::shared_ptr<const PhraseEvaluator>& phrases,
        const SessionHistory& history);

} // namespace parlour::dialogue
