// The part of a conversation that works off the dialogue lane (engine rule 2).
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"

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
  case ring:
    if (!step.more->ring->stopped)
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
    core.machine.push(std::move(step));
    break;
  case pop:
    core.machine.pop(std::move(step));
    break;
  case give_up:
    core.machine.give_up(std::move(step));
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
  if (auto before = core.topics.overtaken_by(step); !before.empty()) {
    before.push_back(std::move(step));
    core.lane.now(std::move(before));
    return;
  }
  script::ActivationContext context;
  if (step.more)
    context.message = step.more->message;
  context.topic = step.topic;
  context.slot = step.slot;
  context.turn = step.turn;
  context.leaves_state = step.kind == StepKind::run_leaving;
  started(core.runner.start(step.code, step.more ? step.more->arguments : none,
                            std::move(context), step.origin));
}

// An activation goes on in the lane where it was started.
void Conversation::Implementation::resume(Step&& step) {
  if (core.pipeline.waits(step.wait))
    core.pipeline.resume(step.wait, *step.more->data);
  else if (core.lane.waits(step.wait))
    core.lane.wake(step.wait, std::move(step));
  else if (core.runner.waiting(step.wait))
    started(core.runner.resume(step.wait, *step.more->data));
}

// What it asked for so far does not wait, and neither does the question that
// this leads to where the script waits for time. Who asks again has dropped
// what he asked before.
void Conversation::Implementation::started(WaitId wait) {
  using enum Runner::WaitFor;
  auto steps = core.runner.hand_over();
  if (wait != 0) {
    const auto what = core.runner.waits_for(wait);
    core.lane.wait(wait, what == answer ? Lane::Others::are_held
                                        : Lane::Others::go_on);
    if (!steps.empty() && what == time)
      steps.push_back(conclude_step(core.runner.turn_of(wait)));
    steps.prepend(core.machine.dropped_by(wait));
  }
  core.lane.now(std::move(steps));
}

} // namespace parlour::dialogue
