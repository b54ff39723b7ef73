#include "script/dialogue/engine/core.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

namespace {

bool wants_out(const Step& step) {
  return step.kind == StepKind::take_act &&
         (step.act->kind == ActKind::cancel ||
          step.act->kind == ActKind::abandon ||
          step.act->kind == ActKind::restart);
}

} // namespace

Core::Core(std::shared_ptr<const script::Program> the_program,
           Conversation::Options the_options, Port& the_port)
    : program(std::move(the_program)), options(std::move(the_options)),
      port(the_port), interpreter(program), frames(*program, interpreter),
      order(*program), timers(port), mouth(*this), effects(*this),
      runner(*this), pipeline(*this), answers(*this), machine(*this),
      topics(*this), privacy(*this) {}

void Core::raise(const char* source, std::string command,
                 std::vector<Value> params, TurnId turn) {
  privacy.note_variables();
  Message message;
  message.time = now;
  message.source = source;
  message.command = std::move(command);
  message.params = std::move(params);
  message.session = options.session;
  message.rounds = rounds;
  Input input;
  input.message = make_short_lived<const Message>(std::move(message));
  input.turn = turn;
  input.raised = true;
  turns.hold(turn);
  if (port.inspected())
    port.inspect(
        {.kind = InspectionKind::message,
         .session = options.session,
         .subject = input.message->source + "." + input.message->command,
         .detail = to_string(*input.message),
         .message = input.message,
         .way = "session"});
  internal.push_back(std::move(input));
}

Correlation Core::post(std::string module, std::string command,
                       std::vector<Value> params, TurnId turn) {
  privacy.note_variables();
  const bool meaning = command == "DoNLU" && port.is_source("NLU", module);
  if (meaning && params.size() == 1)
    params.push_back(topics.understanding_context());
  Message message;
  message.source = "Script";
  message.command = std::move(command);
  message.params = std::move(params);
  message.sinks = {std::move(module)};
  message.session = options.session;
  message.correlation = next_id();
  message.rounds = rounds + 1;
  const auto correlation = message.correlation;
  turns.asked(correlation, turn,
              now + program->settings.sessions.request_timeout.count(),
              meaning);
  for (auto& event : port.post(std::move(message))) {
    turns.hold(turn);
    turns.answered(correlation);
    internal.push_back(
        {.message = std::make_shared<const Message>(std::move(event)),
         .turn = turn});
  }
  return correlation;
}

bool Core::answered_inline(Correlation correlation) const {
  return std::any_of(internal.begin(), internal.end(), [&](const Input& input) {
    return input.message->correlation == correlation;
  });
}

void Core::take_from_pipeline(StepList steps, TurnId turn) {
  if (steps.empty())
    return;
  // Cancel and start over pass every wait (engine rule 2).
  if (std::any_of(steps.begin(), steps.end(), wants_out) && lane.held()) {
    lane.now(cancel_waits(topics.confirms_but_of({})));
    machine.clear_pushed();
  }
  steps.push_back(conclude_step(turn));
  lane.queue(std::move(steps));
}

void Core::resume(WaitId wait, Expected<Value> outcome) {
  effects.forget(wait);
  if (!lane.waits(wait)) {
    pipeline.resume(wait, std::move(outcome));
    return;
  }
  lane.wake(wait, outcome_step(wait, std::move(outcome)));
}

StepList Core::cancel_waits(const std::vector<WaitId>& but) {
  auto waits = lane.abandon(but);
  for (auto wait : pipeline.waits())
    if (runner.waits_for(wait) == Runner::WaitFor::user)
      waits.push_back(wait);
  topics.forget_waits(but);
  StepList steps;
  for (auto wait : waits) {
    effects.forget(wait);
    steps.push_back(outcome_step(
        wait, fail(ErrorKind::cancelled, "the wait was cancelled")));
  }
  return steps;
}

bool Core::one_more_internal_event() {
  if (++internal_events <= defaults::internal_events)
    return true;
  for (const auto& input : std::exchange(internal, {}))
    drop(input);
  if (!std::exchange(chased, true)) {
    internal_events = 0; // those who hear of it may do something about it
    script_failed({ErrorKind::limit,
                   "more than " + std::to_string(defaults::internal_events) +
                       " internal events without an external one; the rest is "
                       "dropped",
                   {}},
                  0);
  }
  return false;
}

void Core::drop(const Input& input) {
  turns.let_go(input.turn);
  mouth.handled(*input.message, false);
}

void Core::drop(const Step& step) {
  if (step.kind == StepKind::push) // who pushed does not wait for ever
    lane.queue({outcome_step(
        step.wait, fail(ErrorKind::cancelled, "the state was not entered"))});
}

void Core::raise_error(const Error& error, TurnId turn) {
  raise("Script", "Error",
        {error.message, error.place.file, std::int64_t{error.place.line}},
        turn);
}

void Core::script_failed(const Error& error, TurnId turn) {
  inspect(InspectionKind::error, std::string(name_of(error.kind)),
          to_string(error));
  raise_error(error, turn);
}

void Core::inspect(InspectionKind kind, std::string subject,
                   std::string detail) {
  privacy.note_variables();
  if (port.inspected() || kind == InspectionKind::error ||
      kind == InspectionKind::log)
    port.inspect({.kind = kind,
                  .session = options.session,
                  .subject = std::move(subject),
                  .detail = std::move(detail)});
}

} // namespace parlour::dialogue
