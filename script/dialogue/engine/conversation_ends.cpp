// The part of a conversation that says how it begins and how it ends (engine
// rule 4.6).
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

void Conversation::Implementation::open() {
  if (auto ready = context.interpreter.initialise(effects); !ready) {
    context.inspect(InspectionKind::error, "variables",
                    to_string(ready.error()));
    context.ending = true;
  } else {
    context.raise("Session", "Started", {});
    context.lane.queue(beginning());
  }
  go_on();
}

// The start state or topic, else the first topic of system initiative
// (engine rule 4.6).
StepList Conversation::Implementation::beginning() const {
  const auto& start = context.program->settings.start;
  Step step;
  if (auto state = context.program->state(start); state != script::no_id) {
    step.kind = StepKind::enter;
    step.state = state;
  } else if (auto topic = context.program->topic(start);
             topic != script::no_id) {
    step = topic_step(StepKind::activate, topic);
  } else if (auto next = context.order.next(); next) {
    step = topic_step(StepKind::resume_topic, next->topic);
  } else {
    return {};
  }
  return {step, make_step(StepKind::greet_agents, {}), conclude_step(0)};
}

void Conversation::Implementation::close() {
  if (leaving_ != Leaving::no)
    return;
  context.ending = true;
  context.leaving = true;
  output.withdraw_questions();
  topics.forget_frame();
  answers.clear();
  context.lane.clear();
  auto steps = topics.cancel_waits();
  for (auto wait : pipeline.waits())
    pipeline.resume(wait, fail(ErrorKind::cancelled, "the session ended"));
  steps.append(machine.exits());
  context.lane.clear();
  context.lane.now(std::move(steps));
  context.timers.start(context.program->settings.sessions.request_timeout,
                       Timer::Purpose::leaving);
  leaving_ = Leaving::exits;
  leave();
}

// Exit runs, then Session.Ended is told; each may wait for a component.
void Conversation::Implementation::leave() {
  run_lane();
  take_internal();
  if (!at_rest())
    return;
  if (leaving_ == Leaving::exits) {
    leaving_ = Leaving::told;
    context.raise("Session", "Ended", {});
    take_internal();
  }
  if (at_rest())
    finish();
}

void Conversation::Implementation::take_internal() {
  while (!context.internal.empty() && context.one_more_internal_event()) {
    process(context.internal.take());
    run_lane();
  }
}

// Nothing that was begun waits for anybody but the user, who is gone.
bool Conversation::Implementation::at_rest() const {
  return context.lane.idle() && context.internal.empty() &&
         !runner.waits_for_others() && !topics.awaiting_frame();
}

void Conversation::Implementation::finish() {
  output.withdraw_questions();
  output.release();
  tell_lost_timers();
  context.timers.cancel_all();
  context.ended = true;
  context.port.ended();
}

// Repeating ones never were to have a last time.
void Conversation::Implementation::tell_lost_timers() {
  for (const auto* timer : context.timers.pending())
    if (timer->every == Milliseconds::zero())
      context.inspect(InspectionKind::log, "warning",
                      "the timer '" + timer->name +
                          "' is lost with its session; it was due at " +
                          format_timestamp(timer->due, "%Y-%m-%d %H:%M:%S"));
}

std::vector<Message> Conversation::Implementation::take_unread() {
  std::vector<Message> messages;
  for (auto& input : std::exchange(context.inbox, {}))
    messages.push_back(*input.message);
  return messages;
}

} // namespace parlour::dialogue
