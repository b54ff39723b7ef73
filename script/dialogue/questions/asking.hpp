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

// The only way from a question as data to an output. It is called by who
// decides that something is to be asked: Reprompts for slots, Confirmations for
// scripts, Clarification and Silence. It keeps nothing: the question itself is
// kept by OpenQuestion, and replaces the one before.
class Asking {
public:
  Asking(DialogueContext& context, OutputManager& output, TopicFrames& frames,
         TextEvaluator& texts, TopicWords& words, OpenQuestion& question)
      : context_(context), output_(output), frames_(frames), texts_(texts),
        words_(words), question_(question) {}

  // Says it, as that act of the engine (a phrase) or, where `text` is not
  // empty, with those words. Turn, output, level and state of `asked` are set
  // here. If nothing could be said, the question counts as heard.
  void put(Asked&& asked, const char* act, Value data, std::string text,
           OutputAct as, TurnId turn);
  // For the slot's value, or what is in doubt about it. Nothing is asked for an
  // empty slot that a topic of its own fills: that topic begins.
  void ask_slot(TopicId topic, SlotId slot, OutputAct as, TurnId turn);
  // Whether all that the topic was told is right (engine rule 5.13). `asked` is
  // the <confirm> that waits for the answer.
  void ask_summary(Asked&& asked, OutputAct as, TurnId turn);
  // What of it is to be another: after a no to the summary.
  void ask_change(Asked&& asked, OutputAct as, TurnId turn);
  // What a question without words of its own is made from: the slot's label;
  // unknown, where it has none.
  Value question_data(const Asked& asked) const;

  // No question waits any more, nor is one said that waits for its release.
  // What was heard cannot be taken back; what is said to it answers nothing.
  void withdraw() {
    withdraw_words();
    question_.reset();
  }
  // The words only: the question stays open.
  void withdraw_words() {
    output_.withdraw_questions();
  }

private:
  // Whether a topic of its own begins for the slot.
  bool begin_part(TopicId topic, SlotId slot, TurnId turn);
  // Whether the slot has an offer now that waits for a yes (engine rule 5.9).
  bool make_offer(TopicId topic, SlotId slot);
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
