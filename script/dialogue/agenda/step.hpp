// Step: one small piece of the dialogue lane's work (engine rules 2, 4, 5).
// Plain data, so that a session can be written out between any two steps.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "script/dialogue/acts/acts.hpp"
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/agenda/state_stack.hpp"
#include "script/dialogue/agenda/turns.hpp"
#include "script/dialogue/frame/frame.hpp"
#include "script/dialogue/knowledge/knowledge_query.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

using script::StateId;

// clang-format off
#define PARLOUR_STEP_KINDS(X) \
  X(take_act, "an act of the user, to whoever is first in order") \
  X(topic_act, "the act to the topic engine") \
  X(conclude, "the utterance is dealt with: what to ask now") \
  X(activate, "a topic becomes the current one") \
  X(fill, "the act's slots to the frame's actor") \
  X(rule, "a rule's body, where its condition holds") \
  X(report, "what became of one slot") \
  X(settle, "whether the topic is done, must be looked up, or goes on") \
  X(finish, "a task's <filled> has run: completed, unless redirected") \
  X(complete, "a topic is completed") \
  X(wind_up, "its <completed> has run: on with what needs it") \
  X(look_up, "the topic's next query") \
  X(looked_up, "its outcome") \
  X(answer, "an enquiry's <filled> has run: answer if it said nothing") \
  X(ask, "the question for a slot") \
  X(ask_still, "the question once more, unless its ladder's step went on") \
  X(ask_next, "the question for what the current topic misses") \
  X(resume_topic, "back to a suspended topic") \
  X(cancel, "the user wants out of a topic, or of all") \
  X(cancel_topic, "it ends as cancelled") \
  X(ask_again, "the question that waits, once more") \
  X(no_match, "nothing was understood: to the reactions that listen") \
  X(not_understood, "nothing was understood: what is done about it") \
  X(no_input, "nothing was said: what is done about it") \
  X(reset, "a topic's slots are emptied by a script") \
  X(restart, "everything begins again") \
  X(end, "the session ends") \
  X(run, "a body of script") \
  X(run_leaving, "the same of an Exit or a <transit>: a state is being left") \
  X(ring, "a timer's statements, unless it was stopped since it rang") \
  X(react, "a reaction's body, unless one before has kept the act for itself") \
  X(resume_wait, "a waiting activation goes on with `data`") \
  X(transit, "leave the state for another") \
  X(leave, "the state's Exit") \
  X(enter, "the state's Entrance") \
  X(push, "enter a state as a subtask") \
  X(pop, "come back from it") \
  X(give_up, "what a handler that asks again had asked before") \
  X(greet_agents, "Online of the agents that are there from the start")
// clang-format on

enum class StepKind : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_STEP_KINDS(X)
#undef X
};

using WaitId = std::uint64_t; // 0: none

// Where a piece of script stands: what it starts may end with that.
struct Origin {
  VisitId visit = 0;              // of the state that it is of; 0: of none
  CodeId timer = script::no_code; // of the timer that it is of
};

// A timer that rang, as long as anything of its statements is still to come.
struct Ring {
  std::string name;
  VisitId visit = 0;
  bool stopped = false;
};

// What only some kinds of steps carry.
struct StepMatter {
  std::vector<Value> arguments; // of the code
  std::shared_ptr<const Message> message;
  std::optional<KnowledgeQuery> query;
  std::optional<Statement> statement;
  std::optional<Expected<Value>> data; // of resume_wait, looked_up
  std::shared_ptr<Ring> ring;          // of a timer; its own until all is done
};

// Small, as it is moved often: what is large is shared. Null where the kind
// has no use for it.
struct Step {
  StepKind kind = StepKind::run;
  OutputAct output = OutputAct::question; // of ask
  TopicId topic = script::no_id;
  SlotId slot = script::no_id;
  StateId state = script::no_id;
  CodeId code = script::no_code;
  std::uint32_t index = 0; // which of the topic's rules, or of the reports
  TurnId turn = 0;
  std::uint64_t mark = 0;    // how many outputs there were before
  std::uint64_t offered = 0; // of the message that reactions may consume
  WaitId wait = 0;
  Origin origin; // of the code
  ActPointer act;
  std::shared_ptr<const FrameResult> result;
  std::shared_ptr<StepMatter> more;

  StepMatter& matter() { // made where there is none
    if (!more)
      more = std::make_shared<StepMatter>();
    return *more;
  }
};

} // namespace parlour::dialogue
