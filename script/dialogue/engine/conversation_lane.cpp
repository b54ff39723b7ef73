// The part of a conversation that works off the dialogue lane (engine rule 2).
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

void Conversation::Implementation::run_lane() {
  while (!topics.awaiting_frame()) {
    auto* step = context.lane.next();
    if (!step)
      break;
    take(std::move(*step));
  }
  if (!context.dropped.empty())
    drop_what_was_too_much();
}

void Conversation::Implementation::drop_what_was_too_much() {
  for (const auto& input : std::exchange(context.dropped, {}))
    output.handled(*input.message, false);
}

void Conversation::Implementation::resume_in_pipeline(WaitId wait,
                                                      Expected<Value> outcome) {
  pipeline.resume(wait, std::move(outcome));
}

std::vector<WaitId> Conversation::Implementation::waits_in_pipeline() const {
  return pipeline.waits();
}

void Conversation::Implementation::forget_request(WaitId wait) {
  effects.forget(wait);
}

void Conversation::Implementation::take(Step&& step) {
  using enum StepKind;
  switch (step.kind) {
  case react:
    if (!topics.consumed(step.offered))
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
    machine.transit(std::move(step));
    break;
  case leave:
    machine.leave(step);
    break;
  case enter:
    machine.enter(step);
    break;
  case push:
    machine.push(std::move(step));
    break;
  case pop:
    machine.pop(std::move(step));
    break;
  case give_up:
    machine.give_up(std::move(step));
    break;
  case greet_agents:
    machine.greet_agents();
    break;
  case end:
    context.ending = true;
    output.withdraw_questions();
    break;
  case restart:
    start_over();
    break;
  default:
    topics.take(std::move(step));
  }
}

void Conversation::Implementation::start_over() {
  context.lane.now(topics.cancel_waits());
  machine.clear();
  topics.restart();
  context.lane.queue(beginning());
}

void Conversation::Implementation::run_body(Step&& step) {
  static const std::vector<Value> none;
  if (auto before = topics.overtaken_by(step); !before.empty()) {
    before.push_back(std::move(step));
    context.lane.now(std::move(before));
    return;
  }
  script::ActivationContext activation;
  if (step.more)
    activation.message = step.more->message;
  activation.topic = step.topic;
  activation.slot = step.slot;
  activation.turn = step.turn;
  activation.leaves_state = step.kind == StepKind::run_leaving;
  started(runner.start(step.code, step.more ? step.more->arguments : none,
                       std::move(activation), step.origin));
}

// An activation goes on in the lane where it was started.
void Conversation::Implementation::resume(Step&& step) {
  const auto wait = step.wait;
  if (pipeline.waits(wait))
    pipeline.resume(wait, *step.more->data);
  else if (context.lane.waits(wait))
    context.lane.wake(wait, std::move(step));
  else if (runner.waiting(wait))
    started(runner.resume(wait, *step.more->data));
}

// What it asked for so far does not wait, and neither does the question that
// this leads to where the script waits for time. Who asks again has dropped
// what he asked before.
void Conversation::Implementation::started(WaitId wait) {
  using enum ActivationRunner::WaitFor;
  auto steps = runner.hand_over();
  if (wait != 0) {
    const auto what = runner.waits_for(wait);
    context.lane.wait(wait, what == answer ? Lane::Others::are_held
                                           : Lane::Others::go_on);
    if (!steps.empty() && what == time)
      steps.push_back(conclude_step(runner.turn_of(wait)));
    steps.prepend(machine.dropped_by(wait));
  }
  context.lane.now(std::move(steps));
}

} // namespace parlour::dialogue
