// The part of a conversation that works off the dialogue lane (engine rule 2).
#include <utility>

#include "script/dialogue/conversation.hpp"
#include "script/dialogue/conversation_implementation.hpp"
#include "script/dialogue/steps.hpp"

namespace parlour::dialogue {

void Conversation::Implementation::run_lane() {
  while (!core.topics.awaiting_frame()) {
    auto* step = core.lane.next();
    if (!step)
      return;
    take(std::move(*step));
  }
}

void Conversation::Implementation::take(Step&& step) {
  using enum StepKind;
  switch (step.kind) {
  case react:
    if (!core.topics.consumed(step.offered))
      run_body(std::move(step));
    break;
  case run:
  case run_leaving:
    run_body(std::move(step));
    break;
  case resume_wait:
    resume(std::move(step));
    break;
  case transit:
    core.machine.transit(std::move(step));
    break;
  case leave:
    core.machine.leave(step);
    break;
  case enter:
    core.machine.enter(step);
    break;
  case push:
    core.machine.push(step);
    break;
  case pop:
    core.machine.pop(step);
    break;
  case greet_agents:
    core.machine.greet_agents();
    break;
  case end:
    core.ending = true;
    core.mouth.withdraw_questions();
    break;
  case restart:
    start_over();
    break;
  default:
    core.topics.take(std::move(step));
  }
}

void Conversation::Implementation::start_over() {
  core.lane.now(core.cancel_waits());
  core.machine.clear();
  core.topics.restart();
  core.lane.queue(beginning());
}

void Conversation::Implementation::run_body(Step&& step) {
  static const std::vector<Value> none;
  script::ActivationContext context;
  if (step.more)
    context.message = step.more->message;
  context.topic = step.topic;
  context.slot = step.slot;
  context.turn = step.turn;
  context.leaves_state = step.kind == StepKind::run_leaving;
  started(core.runner.start(step.code, step.more ? step.more->arguments : none,
                            std::move(context)));
}

// An activation goes on in the lane where it was started.
void Conversation::Implementation::resume(Step&& step) {
  if (core.pipeline.waits(step.wait))
    core.pipeline.resume(step.wait, *step.more->data);
  else if (core.runner.waiting(step.wait))
    started(core.runner.resume(step.wait, *step.more->data));
}

void Conversation::Implementation::started(WaitId wait) {
  auto steps = core.runner.hand_over();
  if (wait != 0)
    core.lane.wait(wait, core.runner.for_user(wait));
  core.lane.now(std::move(steps));
}

} // namespace parlour::dialogue
