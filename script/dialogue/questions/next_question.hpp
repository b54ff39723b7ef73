// NextQuestion: what is asked when all else of an utterance is done: what the
// current topic misses (engine rule 5).
#pragma once

#include <cstdint>
#include <utility>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/questions/topic_words.hpp"

namespace parlour::dialogue {

// Engine rule 5.9. It asks at most once for each utterance, and never in the
// middle of one: the Conclude step is the last of an utterance's item. It keeps
// what the latest utterance was about, and how much had been said before it.
class NextQuestion {
public:
  NextQuestion(DialogueContext& context, OutputManager& output,
               TopicFrames& frames, TopicWords& words, OpenQuestion& question,
               Confirmations& confirmations, Reprompts& reprompts)
      : context_(context), output_(output), frames_(frames), words_(words),
        question_(question), confirmations_(confirmations),
        reprompts_(reprompts) {}

  // All acts of the utterance are dealt with. Nothing is asked while a question
  // waits that was heard or will be.
  void take(const steps::Conclude& step);
  // A topic was begun or resumed without an utterance; a question that waits
  // does not hinder.
  void take(const steps::AskNext& step);
  // Which slot the topic asks for now; or no_id: nothing is in doubt or
  // missing, it is not active, or it leaves the lead to the user.
  SlotId to_ask(TopicId topic) const;

  // The user turn that acts come from now. Outputs are counted from its first
  // act on.
  void turn_begins(TurnId turn) {
    if (std::exchange(turn_, turn) != turn)
      said_before_ = output_.spoken();
  }
  // That turn gives values for this topic, which may therefore ask in a pushed
  // state, too (engine rule 4.3).
  void speaks_of(TopicId topic, TurnId turn) {
    spoken_of_ = {topic, turn};
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, output_, frames_, words_, question_,
                    confirmations_, reprompts_);
    archive(spoken_of_, turn_, said_before_);
  }

private:
  void ask_what_misses(OutputAct as, TurnId turn); // of the current topic
  bool waits_for_user(TopicId topic) const;
  // Never silent: a topic that may not ask has heard what was said.
  void acknowledge_unasked(TurnId turn);

  DialogueContext& context_;
  OutputManager& output_;
  TopicFrames& frames_;
  TopicWords& words_;
  OpenQuestion& question_;
  Confirmations& confirmations_;
  Reprompts& reprompts_;
  struct TurnOf {
    TopicId topic = script::no_id;
    TurnId turn = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive.topic(topic);
      archive(turn);
    }
  } spoken_of_;                   // what the latest utterance was about
  TurnId turn_ = 0;               // the latest
  std::uint64_t said_before_ = 0; // outputs that were made before that
};

} // namespace parlour::dialogue
