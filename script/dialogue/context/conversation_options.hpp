// What a conversation is made with, beside its program and its port. Saved
// bytes hold none of it: whoever restores a conversation gives it again (engine
// rule 7.8).
#pragma once

#include <cstdint>
#include <memory>

#include "runtime/message/message.hpp"
#include "runtime/message/phrases.hpp"

namespace parlour::dialogue {

struct ConversationOptions {
  SessionId session;
  // From it follow all random numbers of the scripts, and which wording of a
  // phrase comes first.
  std::uint64_t seed = 1;
  // Words what the engine says where no NLG component is there. Null: such
  // things are not said, which is shown as an error.
  std::shared_ptr<const PhraseEvaluator> phrases;
  // The configured seat where it happens; empty: none of those.
  std::string seat = {};
};

} // namespace parlour::dialogue
