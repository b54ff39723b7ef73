// ActEntry: the first to take what the user did: who listens to it, and who
// waits for it, goes before the topics (engine rule 2).
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/next_question.hpp"
#include "script/dialogue/questions/offers.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/topic_engine/breath.hpp"
#include "script/dialogue/topic_engine/course/silence.hpp"
#include "script/dialogue/topic_engine/topic_acts.hpp"
#include "script/dialogue/topic_engine/yes_or_no.hpp"

namespace parlour::dialogue {

// Who may take an act, in this order (engine rule 2.8): a yes or no that was
// kept for more of the same breath; the question that it answers, unless a
// state is pushed; the reactions of state and handlers; the topics. It keeps
// nothing itself.
class ActEntry {
public:
  ActEntry(DialogueContext& context, Offers& offers, OpenQuestion& question,
           Confirmations& confirmations, Reprompts& reprompts,
           NextQuestion& next_question, Breath& breath, YesOrNo& yes_or_no,
           Silence& silence, TopicActs& topic_acts)
      : context_(context), offers_(offers), question_(question),
        confirmations_(confirmations), reprompts_(reprompts),
        next_question_(next_question), breath_(breath), yes_or_no_(yes_or_no),
        silence_(silence), topic_acts_(topic_acts) {}

  // One act of a frame list. The act has held its turn open while it was
  // queued, and lets it go here.
  void take(steps::TakeAct&& step);
  // An utterance without any act.
  void take(const steps::NoMatch& step);
  // Whether a script waits for this act: by a <confirm>, or in a pushed state
  // that listens to it. Who wants out is always waited for.
  bool is_waited_for(const Act& act) const;

private:
  // To the reactions; the step follows behind theirs, unless one consumes it.
  void offer_act(steps::TopicAct&& step);
  // Notes private values of the act, its alternatives included.
  void conceal_values(const Act& act);

  DialogueContext& context_;
  Offers& offers_;
  OpenQuestion& question_;
  Confirmations& confirmations_;
  Reprompts& reprompts_;
  NextQuestion& next_question_;
  Breath& breath_;
  YesOrNo& yes_or_no_;
  Silence& silence_;
  TopicActs& topic_acts_;
};

} // namespace parlour::dialogue
