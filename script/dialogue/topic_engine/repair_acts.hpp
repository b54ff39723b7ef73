// RepairActs: acts that are about the conversation itself: a <repair> says what
// is done about them (engine rule 5).
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/topic_engine/breath.hpp"
#include "script/dialogue/topic_engine/topic_ends.hpp"

namespace parlour::dialogue {

class RepairActs {
public:
  RepairActs(OpenQuestion& question, RepairRunner& repairs,
             Reprompts& reprompts, Breath& breath, TopicEnds& ends)
      : question_(question), repairs_(repairs), reprompts_(reprompts),
        breath_(breath), ends_(ends) {}

  void generic_act(const steps::TopicAct& step, TopicId topic);

private:
  OpenQuestion& question_;
  RepairRunner& repairs_;
  Reprompts& reprompts_;
  Breath& breath_;
  TopicEnds& ends_;
};

} // namespace parlour::dialogue
