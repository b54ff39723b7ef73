// DialogueContext: what every part of one conversation may read: the program,
// the clock, what is queued, frames, states, timers, the dialogue lane. It
// knows no part that works with it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "script/dialogue/agenda/lane.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/state_stack.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/agenda/turns.hpp"
#include "script/dialogue/context/apologies.hpp"
#include "script/dialogue/context/conversation_options.hpp"
#include "script/dialogue/context/input.hpp"
#include "script/dialogue/context/privacy.hpp"
#include "script/dialogue/frame/frames.hpp"
#include "script/dialogue/topics/topic_order.hpp"
#include "script/support/fifo.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

using script::SlotId;
using script::TopicId;

struct DialogueContext {
  DialogueContext(std::shared_ptr<const script::Program> the_program,
                  ConversationOptions the_options, Port& the_port);

  std::shared_ptr<const script::Program> program;
  ConversationOptions options;
  Port& port;

  Timestamp now = 0; // constant within one event
  std::uint64_t last_id = 0;
  bool ending = false;  // as soon as all is said
  bool leaving = false; // the user is not there any more
  bool ended = false;

  Fifo<Input> inbox;          // from outside, in order of arrival
  Fifo<Input> internal;       // before any external event (engine rule 2)
  Fifo<Input> dropped;        // of these, what was too much: nobody handles it
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
  // Null: there is no active state.
  const script::State* active_state() const {
    return states.active() == script::no_id ? nullptr
                                            : &program->states[states.active()];
  }

  // An event of a reserved source, raised in this session.
  void raise(const char* source, std::string command, std::vector<Value> params,
             TurnId turn = 0);
  // Sends a message on behalf of a turn; what inline components answer is
  // queued before any external event. Returns its correlation.
  Correlation post(std::string module, std::string command,
                   std::vector<Value> params, TurnId turn);
  bool answered_inline(Correlation correlation) const;
  // False where there were too many of them without an external one: scripts
  // chase each other (engine rule 2). What is queued is dropped then, and
  // Script.Error raised, once.
  bool one_more_internal_event();
  // Script.Error (language rule 12.19).
  void raise_error(const Error& error, TurnId turn);
  // Shown, and raised.
  void script_failed(const Error& error, TurnId turn);
  // Errors and logs are told even where nobody watches.
  void inspect(InspectionKind kind, std::string subject, std::string detail);
  // A statement that a test's coverage counts is about to run.
  void reached(script::Position position) {
    if (port.inspected()) [[unlikely]]
      tell_reached(position);
  }
  // What a slot is, or is to become, where it is private.
  void conceal(TopicId topic, SlotId slot, const Value& value) {
    privacy.note(topic, slot, value, now);
  }
  void conceal(TopicId topic, std::span<const FrameChange> changes) {
    privacy.note(topic, changes, now);
  }

private:
  void tell_reached(script::Position position);
};

} // namespace parlour::dialogue
