// The part of a conversation that says how it begins and how it ends (engine
// rule 4.6).
#include <utility>

#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

// Session.Started is queued before the start state is entered, and taken behind
// it, as the lane runs first.
void ConversationImplementation::open() {
  if (auto ready = interpreter.initialise(effects); !ready) {
    context.inspect(InspectionKind::error, "variables",
                    to_string(ready.error()));
    context.ending.wish();
  } else {
    messenger.raise("Session", "Started", {});
    context.lane.queue(beginning());
  }
  go_on();
}

// The start state or topic, else the first topic of system initiative
// (engine rule 4.6).
StepList ConversationImplementation::beginning() const {
  const auto& start = context.program->settings.start;
  StepList beginning;
  if (auto state = context.program->state(start); state != script::no_id)
    beginning.add(steps::Enter{state});
  else if (auto topic = context.program->topic(start); topic != script::no_id)
    beginning.add(steps::Activate{topic});
  else if (auto next = frames.order().next(); next)
    beginning.add(steps::ResumeTopic{next->topic});
  else
    return {};
  beginning.add(steps::GreetAgents{});
  beginning.add(steps::Conclude{});
  return beginning;
}

// Everything that waits is ended, in both lanes, then the Exit of each level
// runs. The lane is cleared a second time, as the pipeline's scripts have
// handed over steps when their waits ended: nobody is to be asked any more. A
// timer limits what Exit and the handlers of Session.Ended may wait for.
void ConversationImplementation::close() {
  if (!context.ending.begin())
    return;
  output.withdraw_questions();
  topics.forget_frame();
  answers.clear();
  context.lane.clear();
  auto steps = waits.cancel(pipeline.waits());
  for (auto wait : pipeline.waits())
    pipeline.resume(wait, fail(ErrorKind::cancelled, "the session ended"));
  steps.append(machine.exits());
  context.lane.clear();
  context.lane.now(std::move(steps));
  const auto& settings = context.program->settings.sessions;
  timers.start(context.in(settings.request_timeout), Timer::Purpose::leaving);
  leave();
}

// Exit runs, then Session.Ended is told; each may wait for a component. Called
// after each input until all is done, so it begins where it stopped: Ending
// knows what has been told.
void ConversationImplementation::leave() {
  run_lane();
  take_internal();
  if (!is_quiescent())
    return;
  if (context.ending.tell()) {
    messenger.raise("Session", "Ended", {});
    take_internal();
  }
  if (is_quiescent())
    finish();
}

// The internal events that there are, all at once: nothing else has to come in
// between at the end.
void ConversationImplementation::take_internal() {
  while (inbox.has_internal() && messenger.one_more_internal_event()) {
    process(inbox.take_internal());
    run_lane();
  }
}

// Nothing that was begun waits for anybody but the user, who is gone.
bool ConversationImplementation::is_quiescent() const {
  return context.lane.idle() && !inbox.has_internal() &&
         !runner.waits_for_others() && !topics.awaiting_frame();
}

// What can still be said is released, but no question. After ended() nothing is
// wanted of the port.
void ConversationImplementation::finish() {
  output.withdraw_questions();
  output.release();
  tell_lost_timers();
  timers.cancel_all();
  context.ending.finish();
  context.port.ended();
}

// Repeating ones never were to have a last time.
void ConversationImplementation::tell_lost_timers() {
  for (const auto* timer : timers.pending())
    if (timer->every == Milliseconds::zero())
      context.inspect(InspectionKind::log, "warning",
                      "the timer '" + timer->name +
                          "' is lost with its session; it was due at " +
                          format_timestamp(timer->due, "%Y-%m-%d %H:%M:%S"));
}

std::vector<Message> ConversationImplementation::take_unread() {
  std::vector<Message> messages;
  for (auto& input : inbox.take_unread())
    messages.push_back(*input.message);
  return messages;
}

} // namespace parlour::dialogue
