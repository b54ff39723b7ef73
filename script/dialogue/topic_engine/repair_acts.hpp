// RepairActs: acts that are about the conversation itself: a <repair> says what
// is done about them (engine rule 5).
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/topic_engine/breath.hpp"
#include "script/dialogue/topic_engine/course/topic_ends.hpp"

namespace parlour::dialogue {

// TopicActs calls it for `help`, `repeat`, `cancel` and the like (engine rule
// 5.2) that have no slots. What is then done is a script, so the application
// can change it. It keeps nothing.
class RepairActs {
public:
  RepairActs(OpenQuestion& question, RepairRunner& repairs,
             Reprompts& reprompts, Breath& breath, TopicEnds& ends)
      : question_(question), repairs_(repairs), reprompts_(reprompts),
        breath_(breath), ends_(ends) {}

  // `topic` is the one that the act names, or no_id; `done` the one that a
  // cancel is about where nothing can be cancelled, or no_id. Without a
  // <repair> for the act, it counts as not understood.
  void generic_act(const steps::TopicAct& step, TopicId topic, TopicId done);

private:
  OpenQuestion& question_;
  RepairRunner& repairs_;
  Reprompts& reprompts_;
  Breath& breath_;
  TopicEnds& ends_;
};

} // namespace parlour::dialogue
