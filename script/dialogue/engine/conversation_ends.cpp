// The part of a conversation that says how it begins and how it ends (engine
// rule 4.6).
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

void Conversation::Implementation::open() {
  if (auto ready = core.interpreter.initialise(core.effects); !ready) {
    core.inspect(InspectionKind::error, "variables", to_string(ready.error()));
    core.ending = true;
  } else {
    core.raise("Session", "Started", {});
    core.lane.queue(beginning());
  }
  go_on();
}

// The start state or topic, else the first topic of system initiative
// (engine rule 4.6).
StepList Conversation::Implementation::beginning() const {
  const auto& start = core.program->settings.start;
  Step step;
  if (auto state = core.program->state(start); state != script::no_id) {
    step.kind = StepKind::enter;
    step.state = state;
  } else if (auto topic = core.program->topic(start); topic != script::no_id) {
    step = topic_step(StepKind::activate, topic);
  } else if (auto next = core.order.next(); next) {
    step = topic_step(StepKind::resume_topic, next->topic);
  } else {
    return {};
  }
  return {step, make_step(StepKind::greet_agents, {}), conclude_step(0)};
}

void Conversation::Implementation::close() {
  if (leaving_ != Leaving::no)
    return;
  core.ending = true;
  core.leaving = true;
  core.mouth.withdraw_questions();
  core.topics.forget_frame();
  core.answers.clear();
  core.lane.clear();
  auto steps = core.cancel_waits();
  for (auto wait : core.pipeline.waits())
    core.pipeline.resume(wait, fail(ErrorKind::cancelled, "the session ended"));
  steps.append(core.machine.exits());
  core.lane.clear();
  core.lane.now(std::move(steps));
  core.timers.start(core.program->settings.sessions.request_timeout,
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
    core.raise("Session", "Ended", {});
    take_internal();
  }
  if (at_rest())
    finish();
}

void Conversation::Implementation::take_internal() {
  while (!core.internal.empty() && core.one_more_internal_event()) {
    process(core.internal.take());
    run_lane();
  }
}

// Nothing that was begun waits for anybody but the user, who is gone.
bool Conversation::Implementation::at_rest() const {
  return core.lane.idle() && core.internal.empty() &&
         !core.runner.waits_for_others() && !core.topics.awaiting_frame();
}

void Conversation::Implementation::finish() {
  core.mouth.withdraw_questions();
  core.mouth.release();
  tell_lost_timers();
  core.timers.cancel_all();
  core.ended = true;
  core.port.ended();
}

// Repeating ones never were to have a last time.
void Conversation::Implementation::tell_lost_timers() {
  for (const auto* timer : core.timers.pending())
    if (timer->every == Milliseconds::zero())
      core.inspect(InspectionKind::log, "warning",
                   "the timer '" + timer->name +
                       "' is lost with its session; it was due at " +
                       format_timestamp(timer->due, "%Y-%m-%d %H:%M:%S"));
}

std::vector<Message> Conversation::Implementation::take_unread() {
  std::vector<Message> messages;
  for (auto& input : std::exchange(core.inbox, {}))
    messages.push_back(*input.message);
  return messages;
}

} // namespace parlour::dialogue
