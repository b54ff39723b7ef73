// Asking: puts a question, which is then the one that waits (OpenQuestion).
#pragma once

#include <string>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/text_evaluator.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/topic_words.hpp"

namespace parlour::dialogue {

class Asking {
public:
  Asking(DialogueContext& context, OutputManager& output, TopicFrames& frames,
         TextEvaluator& texts, TopicWords& words, OpenQuestion& question)
      : context_(context), output_(output), frames_(frames), texts_(texts),
        words_(words), question_(question) {}

  // Says it, as that act of the engine or with those words.
  void put(Asked&& asked, const char* act, Value data, std::string text,
           OutputAct as, TurnId turn);
  // For the slot's value, or what is in doubt about it.
  void ask_slot(TopicId topic, SlotId slot, OutputAct as, TurnId turn);

  // No question waits any more, nor is one said that waits for its release.
  void withdraw() {
    withdraw_words();
    question_.reset();
  }
  void withdraw_words() {
    output_.withdraw_questions();
  }

private:
  void ask_confirmation(TopicId topic, SlotId slot, TurnId turn);
  void ask_choice(TopicId topic, SlotId slot, TurnId turn);

  DialogueContext& context_;
  OutputManager& output_;
  TopicFrames& frames_;
  TextEvaluator& texts_;
  TopicWords& words_;
  OpenQuestion& question_;
};

} // namespace parlour::dialogue
