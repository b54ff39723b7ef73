// ScriptView: what scripts read of their conversation, and the lines that they
// leave for developers. TextEvaluator and conditions are given nothing else.
#pragma once

#include <string>

#include "runtime/base/random.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/program/host.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// Keeps where the random numbers stand, and nothing else.
class ScriptView {
public:
  ScriptView(DialogueContext& context, TopicFrames& frames)
      : context_(context), frames_(frames), random_(context.options.seed) {}

  // `this.X`: unknown outside of topics. A private value is reported before the
  // script has it.
  Value slot(TopicId topic, SlotId slot) const;
  // _SESSION, _STATE and the like (language rule 5.9); those about the message
  // come from the activation itself.
  Value system(const script::ActivationContext& context,
               script::SystemVariable variable) const;
  bool online(const std::string& agent) const {
    return context_.port.reachable(agent);
  }
  Timestamp now() const {
    return context_.now;
  }
  // At least 0 and below 1; the next one of the session's seed.
  double random() {
    return random_.fraction();
  }

  bool watches_branches() const {
    return context_.port.inspected();
  }
  void reached(script::Position position) {
    context_.reached(position);
  }
  // A <log> or <print>.
  void log(const script::Effect& effect);

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, frames_);
    archive(random_);
  }

private:
  DialogueContext& context_;
  TopicFrames& frames_;
  Random random_;
};

} // namespace parlour::dialogue
