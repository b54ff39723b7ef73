// Core: the parts of one conversation, which know each other through it. An
// internal header of this folder; the door is conversation.hpp.
#pragma once

#include <memory>

#include "script/dialogue/agenda/lane.hpp"
#include "script/dialogue/agenda/state_stack.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/agenda/turns.hpp"
#include "script/dialogue/engine/answers.hpp"
#include "script/dialogue/engine/apologies.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/effects.hpp"
#include "script/dialogue/engine/mouth.hpp"
#include "script/dialogue/engine/pipeline.hpp"
#include "script/dialogue/engine/privacy.hpp"
#include "script/dialogue/engine/runner.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/engine/topic_engine.hpp"
#include "script/dialogue/frame/frames.hpp"
#include "script/dialogue/topics/topic_order.hpp"
#include "script/support/fifo.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

struct Core {
  Core(std::shared_ptr<const script::Program> the_program,
       Conversation::Options the_options, Port& the_port);

  std::shared_ptr<const script::Program> program;
  Conversation::Options options;
  Port& port;

  Timestamp now = 0; // constant within one event
  std::uint64_t last_id = 0;
  bool ending = false;  // as soon as all is said
  bool leaving = false; // the user is not there any more
  bool ended = false;

  Fifo<Input> inbox;          // from outside, in order of arrival
  Fifo<Input> internal;       // before any external event (engine rule 2)
  int internal_events = 0;    // since the last external one
  std::uint32_t rounds = 0;   // of the message that was taken last
  std::uint64_t received = 0; // the number of the last message in the inbox
  bool chased = false;        // these internal events were too many

  script::Interpreter interpreter;
  Frames frames;
  TopicOrder order;
  Turns turns;
  StateStack states;
  Apologies apologies;
  Timers timers;
  Lane lane;
  Mouth mouth;
  Effects effects;
  Runner runner;
  Pipeline pipeline;
  Answers answers;
  StateMachine machine;
  TopicEngine topics;
  Privacy privacy;

  std::uint64_t next_id() {
    return ++last_id;
  }
  const script::Topic& topic(TopicId id) const {
    return program->topics[id];
  }
  const Frame& frame(TopicId id) const {
    return frames.get(id, now);
  }

  // An event of a reserved source, raised in this session.
  void raise(const char* source, std::string command, std::vector<Value> params,
             TurnId turn = 0);
  // Sends a message on behalf of a turn; what inline components answer is
  // queued before any external event. Returns its correlation.
  Correlation post(std::string module, std::string command,
                   std::vector<Value> params, TurnId turn);
  bool answered_inline(Correlation correlation) const;
  // What the pipeline hands over becomes an item of the dialogue lane, which
  // ends with the question that is then due.
  void take_from_pipeline(StepList steps, TurnId turn);
  // A waiting activation or step goes on, in whichever lane it waits.
  void resume(WaitId wait, Expected<Value> outcome);
  // The user wants out, or the session ends: what waits in the dialogue lane,
  // and what waits for the user anywhere, is to end with kind Cancelled
  // (engine rule 2), but these. The steps that tell them so, innermost first;
  // pushed states are left to the caller.
  [[nodiscard]] StepList cancel_waits(const std::vector<WaitId>& but = {});
  // False where there were too many of them without an external one: scripts
  // chase each other (engine rule 2). What is queued is dropped then, and
  // Script.Error raised, once.
  bool one_more_internal_event();
  // An event that nobody is to handle any more; what hangs on it goes on.
  void drop(const Input& input);
  // The same for a step.
  void drop(const Step& step);
  // Script.Error (language rule 12.19).
  void raise_error(const Error& error, TurnId turn);
  // Shown, and raised.
  void script_failed(const Error& error, TurnId turn);
  // Errors and logs are told even where nobody watches.
  void inspect(InspectionKind kind, std::string subject, std::string detail);
};

} // namespace parlour::dialogue
