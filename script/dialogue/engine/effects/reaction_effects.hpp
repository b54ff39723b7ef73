// ReactionEffects: what a script does with the message that it handles, and how
// it speaks to other reactions: <fire>, <consume/>, <register>.
#pragma once

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/engine/effects/handled_message.hpp"
#include "script/dialogue/questions/offers.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// Keeps nothing: what it notes is with the parts that it is given.
class ReactionEffects {
public:
  ReactionEffects(DialogueContext& context, Messenger& messenger,
                  Reactions& reactions, RunningScript& running, Offers& offers,
                  HandledMessage& handled)
      : context_(context), messenger_(messenger), reactions_(reactions),
        running_(running), offers_(offers), handled_(handled) {}

  // An internal event of source Script, at once in the inbox (engine rule 2.6).
  script::Performed fire_event(TurnId turn, const script::Effect& effect);
  // Acts, for the dialogue lane, when the script ends or waits. A frame list
  // without any act counts as not understood. An act that names a topic or slot
  // that does not exist is an error of kind Range, unless a reaction to
  // Dialogue listens to such acts.
  script::Performed fire_frames(TurnId turn, const script::Effect& effect);
  // The message that the script handles; null: none, which is an error of kind
  // Refused.
  script::Performed consume(const Message* message);
  script::Performed register_handler(const script::Effect& effect);

private:
  DialogueContext& context_;
  Messenger& messenger_;
  Reactions& reactions_;
  RunningScript& running_;
  Offers& offers_;
  HandledMessage& handled_;
};

} // namespace parlour::dialogue
