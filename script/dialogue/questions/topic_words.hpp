// TopicWords: what is said about topics and slots by phrase.
#pragma once

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/text_evaluator.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"

namespace parlour::dialogue {

// What is common to all that the engine says about a topic: label, type, and
// the values to be echoed. It gives texts to the OutputManager and keeps
// nothing. The answers themselves are phrases, so an application can word each
// of them.
class TopicWords {
public:
  TopicWords(DialogueContext& context, TopicFrames& frames,
             TextEvaluator& texts, OutputManager& output)
      : context_(context), frames_(frames), texts_(texts), output_(output) {}

  // An answer: the phrase of this act, with the values that are to be echoed.
  // topic and slot may be no_id, data unknown.
  void say(const char* act, TopicId topic, SlotId slot, Value data,
           TurnId turn);
  // `data` with a map `implicit`: the values that were accepted and marked
  // (engine rule 5.5). Without such values, or without a topic, as it was.
  Value with_marks(TopicId topic, Value data) const;
  // `data` with the slot's cardinality as `type`, where it has one: a phrase
  // says a time otherwise than a number.
  Value with_type(Map data, TopicId topic, SlotId slot) const;
  // How it is called aloud; unknown: it has no label.
  Value label_of(TopicId topic, SlotId slot = script::no_id) const;
  // Its label as `label`, where it has one.
  Map with_label(Map data, TopicId topic, SlotId slot = script::no_id) const;
  // The slots that the topic was told, or took by default and asks for: a list
  // of {slot, label, value, type}.
  Value told(TopicId topic) const;
  // The robot's last turn once more, or that there is nothing to repeat.
  void repeat(TurnId turn);
  bool may_apologise() {
    return output_.may_apologise();
  }

private:
  DialogueContext& context_;
  TopicFrames& frames_;
  TextEvaluator& texts_;
  OutputManager& output_;
};

} // namespace parlour::dialogue
