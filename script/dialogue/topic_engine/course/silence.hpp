// Silence: what it leads to, and how unfinished topics are taken up again
// (engine rule 5, "Which topic next").
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/asking.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/next_question.hpp"
#include "script/dialogue/questions/offers.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"

namespace parlour::dialogue {

// Engine rule 3.8 as far as topics and questions go: which line of its table
// applies, how long silence must last for it, and what then happens. The
// session keeps the timer; it asks silence_wanted() after each input and calls
// silence() when the timer rings.
class Silence {
public:
  // Looks through all states of the program once.
  Silence(DialogueContext& context, TopicFrames& frames,
          const ActivationRunner& runner, Offers& offers,
          OpenQuestion& question, Asking& asking, Confirmations& confirmations,
          Reprompts& reprompts, NextQuestion& next_question,
          TopicChanges& topic_changes);

  // Silence has lasted: the next question, resume or reprompt. Only a reprompt,
  // and what the state hears, count towards the five times in a row.
  void silence();
  // A question that was heard and is still open is asked again; else nothing.
  void repeat();
  // How long silence must last now: `no-input-after` or `resume-after`; nothing
  // where it leads nowhere.
  std::optional<Milliseconds> silence_wanted() const;
  // Also begins a topic of system initiative that has not begun yet.
  void take(const steps::ResumeTopic& step);

  // Unanswered questions are counted from here again.
  void user_spoke() {
    no_input_ = 0;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, frames_, runner_, offers_, question_, asking_,
                    confirmations_, reprompts_, next_question_, topic_changes_,
                    listens_to_silence_);
    archive(no_input_);
  }

private:
  // What silence leads to.
  enum class Due : std::uint8_t {
    nothing,
    reprompt,     // the question that was heard
    again,        // the one that was withdrawn
    confirmation, // a <confirm>'s, that others were put in front of
    question,     // the current topic's next
    state,        // nothing is asked, but the state listens to silence
    topic,        // another topic
  };

  // The first line of engine rule 3.8 that applies.
  Due due() const;
  bool state_listens() const;
  // There must be an open question, which was withdrawn or interrupted.
  void ask_again();

  DialogueContext& context_;
  TopicFrames& frames_;
  const ActivationRunner& runner_;
  Offers& offers_;
  OpenQuestion& question_;
  Asking& asking_;
  Confirmations& confirmations_;
  Reprompts& reprompts_;
  NextQuestion& next_question_;
  TopicChanges& topic_changes_;
  std::vector<bool> listens_to_silence_; // each state
  int no_input_ = 0;                     // unanswered questions in a row
};

} // namespace parlour::dialogue
