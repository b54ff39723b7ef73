// TopicActs: acts that nobody kept for himself: to the question that waits, to
// who repairs the conversation, or to the topic that they are about (engine
// rule 5, "Acts").
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/questions/clarification.hpp"
#include "script/dialogue/questions/offers.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/questions/whereabouts.hpp"
#include "script/dialogue/topic_engine/act_delivery.hpp"
#include "script/dialogue/topic_engine/course/late_corrections.hpp"
#include "script/dialogue/topic_engine/repair_acts.hpp"
#include "script/dialogue/topic_engine/yes_or_no.hpp"

namespace parlour::dialogue {

// ActEntry calls it, or the lane when reactions were offered the act and kept
// it not. It carries out engine rule 5.3 step by step, up to the filling event,
// which ActDelivery begins. It keeps nothing.
class TopicActs {
public:
  TopicActs(DialogueContext& context, Messenger& messenger, Offers& offers,
            TopicWords& words, OpenQuestion& question, Whereabouts& whereabouts,
            Clarification& clarification, RepairRunner& repairs,
            Reprompts& reprompts, YesOrNo& yes_or_no, RepairActs& repair_acts,
            LateCorrections& late_corrections, ActDelivery& delivery)
      : context_(context), messenger_(messenger), offers_(offers),
        words_(words), question_(question), whereabouts_(whereabouts),
        clarification_(clarification), repairs_(repairs), reprompts_(reprompts),
        yes_or_no_(yes_or_no), repair_acts_(repair_acts),
        late_corrections_(late_corrections), delivery_(delivery) {}

  // What leads to no topic counts as not understood. An act that names a topic
  // or slot that does not exist becomes the event Script.Error (language rule
  // 12.23).
  void take(steps::TopicAct&& step);

private:
  // Replaces the act by its reading for the enquiry that rests, or by one with
  // values that are known, where that is near enough (engine rule 5.3).
  void prefer_reading(steps::TopicAct& step) const;
  // Whether the act is about the conversation, or about what is done; then it
  // is dealt with.
  bool take_about_conversation(const steps::TopicAct& step);
  // It names a slot that is to be another, which is asked for.
  void take_name_of_slot(const steps::TopicAct& step);
  void acknowledge(TurnId turn);
  // The act is about some topic, or about none.
  void find_topic(steps::TopicAct&& step);

  DialogueContext& context_;
  Messenger& messenger_;
  Offers& offers_;
  TopicWords& words_;
  OpenQuestion& question_;
  Whereabouts& whereabouts_;
  Clarification& clarification_;
  RepairRunner& repairs_;
  Reprompts& reprompts_;
  YesOrNo& yes_or_no_;
  RepairActs& repair_acts_;
  LateCorrections& late_corrections_;
  ActDelivery& delivery_;
};

} // namespace parlour::dialogue
