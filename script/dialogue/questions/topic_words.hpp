// TopicWords: what is said about topics and slots by phrase.
#pragma once

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"

namespace parlour::dialogue {

class TopicWords {
public:
  TopicWords(DialogueContext& context, TopicFrames& frames,
             OutputManager& output)
      : context_(context), frames_(frames), output_(output) {}

  // A phrase by act, with the values that are to be echoed.
  void say(const char* act, TopicId topic, SlotId slot, Value data,
           TurnId turn);
  Value with_marks(TopicId topic, Value data) const;
  Value with_type(Map data, TopicId topic, SlotId slot) const;
  void repeat(TurnId turn); // what was heard last
  bool may_apologise() {
    return output_.may_apologise();
  }

private:
  DialogueContext& context_;
  TopicFrames& frames_;
  OutputManager& output_;
};

} // namespace parlour::dialogue
