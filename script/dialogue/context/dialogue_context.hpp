// DialogueContext: what nearly every part of one conversation uses: the program
// and its settings, the time, the port; the dialogue lane, the turns and the
// states that it runs in. It knows no part that works with it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "script/dialogue/agenda/lane.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/state_stack.hpp"
#include "script/dialogue/agenda/turns.hpp"
#include "script/dialogue/context/conversation_options.hpp"
#include "script/dialogue/context/ending.hpp"
#include "script/dialogue/context/privacy.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

using script::SlotId;
using script::TopicId;

// Made by ConversationImplementation before all parts that refer to it, and so
// outlives them. Not thread-safe.
struct DialogueContext {
  // The port and the interpreter must outlive it.
  DialogueContext(const script::Interpreter& interpreter,
                  std::shared_ptr<const script::Program> the_program,
                  ConversationOptions the_options, Port& the_port);

  const std::shared_ptr<const script::Program> program;
  const ConversationOptions options;
  Port& port;

  // Milliseconds since 1970, as the last input told it; constant within one
  // event, so that a replay sees the same.
  Timestamp now = 0;
  Ending ending;
  Turns turns;
  StateStack states;
  Lane lane;
  Privacy privacy;

  // For correlations, waits, queries and sockets alike, so that none of these
  // can be taken for another. Rising from 1.
  std::uint64_t next_id() {
    return ++last_id_;
  }
  // Numbers go on where another conversation's have ended, as answers to that
  // one's may still come.
  void number_after(const DialogueContext& before) {
    last_id_ = before.last_id_;
  }
  const script::Topic& topic(TopicId id) const {
    return program->topics[id];
  }
  // The time when so much has passed.
  Timestamp in(Milliseconds time) const {
    return now + time.count();
  }
  // How long nobody has to speak until the session ends: at its seat.
  Milliseconds closes_after() const;
  // Null: there is no active state.
  const script::State* active_state() const {
    return states.active() == script::no_id ? nullptr
                                            : &program->states[states.active()];
  }

  // Errors and logs are told even where nobody watches. Whoever makes a long
  // text for it asks port.inspected() before.
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

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(program, options, port);
    archive(now, last_id_, ending, turns, states, lane, privacy);
  }

private:
  void tell_reached(script::Position position);

  std::uint64_t last_id_ = 0;
};

} // namespace parlour::dialogue
