#include "script/dialogue/context/dialogue_context.hpp"

#include <algorithm>
#include <utility>

#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

DialogueContext::DialogueContext(
    std::shared_ptr<const script::Program> the_program,
    ConversationOptions the_options, Port& the_port)
    : program(std::move(the_program)), options(std::move(the_options)),
      port(the_port), interpreter(program), frames(*program, interpreter),
      order(*program), timers(port), privacy(*program, interpreter, port) {}

void DialogueContext::raise(const char* source, std::string command,
                            std::vector<Value> params, TurnId turn) {
  privacy.note_variables(now);
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

Correlation DialogueContext::post(std::string module, std::string command,
                                  std::vector<Value> params, TurnId turn) {
  privacy.note_variables(now);
  const bool meaning = command == "DoNLU" && port.is_source("NLU", module);
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

bool DialogueContext::answered_inline(Correlation correlation) const {
  return std::any_of(internal.begin(), internal.end(), [&](const Input& input) {
    return input.message->correlation == correlation;
  });
}

bool DialogueContext::one_more_internal_event() {
  if (++internal_events <= defaults::internal_events)
    return true;
  for (auto& input : std::exchange(internal, {})) {
    turns.let_go(input.turn);
    dropped.push_back(std::move(input));
  }
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

void DialogueContext::raise_error(const Error& error, TurnId turn) {
  raise("Script", "Error",
        {error.message, error.place.file, std::int64_t{error.place.line}},
        turn);
}

void DialogueContext::script_failed(const Error& error, TurnId turn) {
  inspect(InspectionKind::error, std::string(name_of(error.kind)),
          to_string(error));
  raise_error(error, turn);
}

void DialogueContext::inspect(InspectionKind kind, std::string subject,
                              std::string detail) {
  privacy.note_variables(now);
  if (port.inspected() || kind == InspectionKind::error ||
      kind == InspectionKind::log)
    port.inspect({.kind = kind,
                  .session = options.session,
                  .subject = std::move(subject),
                  .detail = std::move(detail)});
}

void DialogueContext::tell_reached(script::Position position) {
  const auto place = program->place(position);
  inspect(InspectionKind::branch, place.file + ":" + std::to_string(place.line),
          "");
}

} // namespace parlour::dialogue
