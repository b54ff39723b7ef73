// TopicWords: what is said about topics and slots, by phrase or by the words of
// the application.
#pragma once

#include <string>

#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"

namespace parlour::dialogue {

class TopicWords {
public:
  TopicWords(DialogueContext& context, TopicFrames& frames,
             ActivationRunner& runner, OutputManager& output)
      : context_(context), frames_(frames), runner_(runner), output_(output) {}

  // A phrase by act, with the values that are to be echoed.
  void say(const char* act, TopicId topic, SlotId slot, Value data,
           TurnId turn);
  Value with_marks(TopicId topic, Value data) const;
  Value with_type(Map data, TopicId topic, SlotId slot) const;
  // What a text of the application comes to now.
  std::string text_of(CodeId code, TopicId topic);
  // The values of a set; a range's bounds, as far as it has them.
  Value choices_of(TopicId topic, SlotId slot);
  void repeat(TurnId turn); // what was heard last
  bool may_apologise() {
    return output_.may_apologise();
  }

private:
  DialogueContext& context_;
  TopicFrames& frames_;
  ActivationRunner& runner_;
  OutputManager& output_;
};

} // namespace parlour::dialogue
