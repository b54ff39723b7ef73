// What a conversation is made with, beside its program and its port.
#pragma once

#include <cstdint>
#include <memory>

#include "runtime/message/message.hpp"
#include "runtime/message/phrases.hpp"

namespace parlour::dialogue {

struct ConversationOptions {
  SessionId session;
  std::uint64_t seed = 1;
  // Words what the engine says where no NLG component is there.
  std::shared_ptr<const PhraseEvaluator> phrases;
};

} // namespace parlour::dialogue
