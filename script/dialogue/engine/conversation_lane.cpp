// The part of a conversation that works off the dialogue lane (engine rule 2).
#include <concepts>
#include <utility>
#include <variant>

#include "script/dialogue/agenda/give.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

// The lane stops where a frame is with its actor: the steps that follow need
// the values (engine rule 5.12). Steps are taken until the lane is idle or
// held, however many come from scripts: their limit is the fuel of the event
// and the count of what they hand over.
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

// An output whose Speak event was among the dropped ones must not wait for its
// words for ever.
void ConversationImplementation::drop_what_was_too_much() {
  for (const auto& input : inbox.take_dropped())
    output.handled(*input.message, false);
}

// The conversation, the state machine and the topic engine are asked in this
// order whether they take steps of that kind; which one does is known when it
// is compiled.
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

// A <cancel timer="…"/> may have come between ringing and running (language
// rule 10.3).
void ConversationImplementation::take(steps::RunTimer&& step) {
  if (!step.ring->stopped)
    run_body(std::move(step));
}

// The reactions to one act are queued together; the first that says <consume/>
// keeps the act from those behind it (engine rule 2.8).
void ConversationImplementation::take(steps::React&& step) {
  if (!questions.offers.consumed(step.body.input->message->number))
    run_body(std::move(step));
}

// The end itself comes when all is said (go_on): "Goodbye." still leaves.
void ConversationImplementation::take(const steps::End&) {
  context.ending.wish();
  output.withdraw_questions();
}

// What waits is ended first, so that a <catch> still sees its topic. The waits
// of other topics go on, unless all is to be cancelled (engine rule 2.5).
// What else was said is done: "never mind, where is the library?"
void ConversationImplementation::take(const steps::Cancel& step) {
  const auto ended = topics.meant_by(step);
  context.lane.set_acts_aside();
  topics.withdraw_question();
  auto steps =
      waits.cancel(pipeline.waits(), step.all ? std::vector<WaitId>()
                                              : topics.confirms_but_of(ended));
  machine.clear_pushed();
  steps.append(topics.cancel(ended, step.turn));
  context.lane.now(std::move(steps));
}

void ConversationImplementation::take(const steps::Restart&) {
  start_over();
}

// Variables stay, and so do timers that do not end with a state. The beginning
// is queued behind the steps that end the waits.
// What else was said counts behind the beginning.
void ConversationImplementation::start_over() {
  auto said = context.lane.take_acts();
  context.lane.now(waits.cancel(pipeline.waits()));
  machine.clear();
  topics.restart();
  context.lane.queue(beginning());
  context.lane.queue(std::move(said));
}

// A topic's <filled> that asked "A taxi at 3?" begins anew when the time was
// changed to 4. The earlier run is ended before that: its steps are put in
// front, and this one comes again behind them.
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
  ran(runner.start(body.code, input.arguments, std::move(activation),
                   body.origin));
}

// An activation goes on in the lane where it was started. For one whose context
// still waits in the dialogue lane, the step comes twice: it wakes the context,
// and is taken again when that has come to the top.
void ConversationImplementation::take(steps::ResumeWait&& step) {
  const auto wait = step.wait;
  if (pipeline.waits(wait))
    pipeline.resume(wait, std::move(*step.outcome));
  else if (context.lane.waits(wait))
    context.lane.wake(wait, std::move(step));
  else if (runner.waiting(wait)) {
    const auto what = runner.resume(wait, std::move(*step.outcome));
    topics.wait_is_over(wait);
    ran(what);
  }
}

// What it asked for so far does not wait, and neither does the question that
// this leads to where the script waits for time. Who asks again has dropped
// what he asked before. A wait for an answer holds the lane, one for the user
// or for time lets it go on (engine rule 2.4).
void ConversationImplementation::ran(ActivationRunner::Ran what) {
  using enum WaitFor;
  if (what.failed != script::no_id)
    topics.body_failed(what.failed, running.body());
  auto wanted = running.hand_over();
  if (const auto wait = what.wait; wait != 0) {
    const auto what_for = runner.waits_for(wait);
    context.lane.wait(wait, what_for == answer ? Lane::Others::are_held
                                               : Lane::Others::go_on);
    if (!wanted.empty() && what_for == time)
      wanted.add(steps::Conclude{runner.turn_of(wait)});
    wanted.prepend(machine.dropped_by(wait));
  }
  context.lane.now(std::move(wanted));
}

} // namespace parlour::dialogue
