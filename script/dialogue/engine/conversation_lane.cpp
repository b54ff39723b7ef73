// The part of a conversation that works off the dialogue lane (engine rule 2).
#include <concepts>
#include <utility>
#include <variant>

#include "script/dialogue/agenda/give.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

void ConversationImplementation::run_lane() {
  while (!topics.awaiting_frame()) {
    auto* step = context.lane.next();
    if (!step)
      break;
    carry_out(std::move(*step));
  }
  if (inbox.has_dropped())
    drop_what_was_too_much();
}

void ConversationImplementation::drop_what_was_too_much() {
  for (const auto& input : inbox.take_dropped())
    output.handled(*input.message, false);
}

void ConversationImplementation::resume_in_pipeline(WaitId wait,
                                                    Expected<Value> outcome) {
  pipeline.resume(wait, std::move(outcome));
}

std::vector<WaitId> ConversationImplementation::waits_in_pipeline() const {
  return pipeline.waits();
}

void ConversationImplementation::forget_request(WaitId wait) {
  requests.forget(wait);
  outside.forget(wait);
}

void ConversationImplementation::carry_out(Step&& step) {
  std::visit([&](auto& kind) { give(std::move(kind), *this, machine, topics); },
             step);
}

void ConversationImplementation::take(steps::Run&& step) {
  run_body(std::move(step));
}

void ConversationImplementation::take(steps::RunLeaving&& step) {
  run_body(std::move(step));
}

void ConversationImplementation::take(steps::RunTimer&& step) {
  if (!step.ring->stopped)
    run_body(std::move(step));
}

void ConversationImplementation::take(steps::React&& step) {
  if (!topics.consumed(step.body.input->message->number))
    run_body(std::move(step));
}

void ConversationImplementation::take(const steps::End&) {
  context.ending.wish();
  output.withdraw_questions();
}

void ConversationImplementation::take(const steps::Restart&) {
  start_over();
}

void ConversationImplementation::start_over() {
  context.lane.now(topics.cancel_waits());
  machine.clear();
  topics.restart();
  context.lane.queue(beginning());
}

template <class Kind>
void ConversationImplementation::run_body(Kind&& step) {
  static const BodyInput none;
  const auto& body = step.body;
  if (auto before = topics.overtaken_by(body); !before.empty()) {
    before.add(std::move(step));
    context.lane.now(std::move(before));
    return;
  }
  const auto& input = body.input ? *body.input : none;
  script::ActivationContext activation;
  activation.message = input.message;
  activation.topic = body.topic;
  activation.slot = body.slot;
  activation.turn = body.turn;
  activation.leaves_state = std::same_as<Kind, steps::RunLeaving>;
  started(runner.start(body.code, input.arguments, std::move(activation),
                       body.origin));
}

// An activation goes on in the lane where it was started.
void ConversationImplementation::take(steps::ResumeWait&& step) {
  const auto wait = step.wait;
  if (pipeline.waits(wait))
    pipeline.resume(wait, std::move(*step.outcome));
  else if (context.lane.waits(wait))
    context.lane.wake(wait, std::move(step));
  else if (runner.waiting(wait))
    started(runner.resume(wait, std::move(*step.outcome)));
}

// What it asked for so far does not wait, and neither does the question that
// this leads to where the script waits for time. Who asks again has dropped
// what he asked before.
void ConversationImplementation::started(WaitId wait) {
  using enum ActivationRunner::WaitFor;
  auto wanted = runner.hand_over();
  if (wait != 0) {
    const auto what = runner.waits_for(wait);
    context.lane.wait(wait, what == answer ? Lane::Others::are_held
                                           : Lane::Others::go_on);
    if (!wanted.empty() && what == time)
      wanted.add(steps::Conclude{runner.turn_of(wait)});
    wanted.prepend(machine.dropped_by(wait));
  }
  context.lane.now(std::move(wanted));
}

} // namespace parlour::dialogue
