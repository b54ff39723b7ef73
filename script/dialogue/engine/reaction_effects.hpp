// ReactionEffects: what a script does with the message that it handles, and how
// it speaks to other reactions: <fire>, <consume/>, <register>.
#pragma once

#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/engine/pipeline.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

class ReactionEffects {
public:
  ReactionEffects(DialogueContext& context, Messenger& messenger,
                  Reactions& reactions, ActivationRunner& runner,
                  TopicEngine& topics, Pipeline& pipeline)
      : context_(context), messenger_(messenger), reactions_(reactions),
        runner_(runner), topics_(topics), pipeline_(pipeline) {}

  script::Performed fire_event(TurnId turn, const script::Effect& effect);
  // Acts, for the dialogue lane.
  script::Performed fire_frames(TurnId turn, const script::Effect& effect);
  // The message that the script handles; null: none.
  script::Performed consume(const Message* message);
  script::Performed register_handler(const script::Effect& effect);

private:
  DialogueContext& context_;
  Messenger& messenger_;
  Reactions& reactions_;
  ActivationRunner& runner_;
  TopicEngine& topics_;
  Pipeline& pipeline_;
};

} // namespace parlour::dialogue
