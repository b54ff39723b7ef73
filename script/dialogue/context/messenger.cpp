#include "script/dialogue/context/messenger.hpp"

#include <memory>
#include <utility>

#include "runtime/base/defaults.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

// An event that is raised is as far from outside as the message that led to it:
// without that, two components that answer each other by way of a script would
// never reach the limit (engine rule 1.6).
void Messenger::raise(const char* source, std::string command,
                      std::vector<Value> params, TurnId turn) {
  context_.privacy.note_variables(context_.now);
  Message message;
  message.time = context_.now;
  message.source = source;
  message.command = std::move(command);
  message.params = std::move(params);
  message.session = context_.options.session;
  message.rounds = inbox_.rounds();
  Input input;
  input.message = make_short_lived<const Message>(std::move(message));
  input.turn = turn;
  input.raised = true;
  if (context_.port.inspected())
    context_.port.inspect(
        {.kind = InspectionKind::message,
         .session = context_.options.session,
         .subject = input.message->source + "." + input.message->command,
         .detail = to_string(*input.message),
         .message = input.message,
         .way = "session"});
  inbox_.add_internal(std::move(input));
}

// The turn is noted as asked before the port is called, as an inline component
// has answered when that returns. Whether the meaning was asked for (DoNLU of
// NLU) decides what becomes of the turn if no answer comes.
Correlation Messenger::post(std::string module, std::string command,
                            std::vector<Value> params, TurnId turn) {
  context_.privacy.note_variables(context_.now);
  const bool meaning =
      command == "DoNLU" && context_.port.is_source("NLU", module);
  Message message;
  message.source = "Script";
  message.command = std::move(command);
  message.params = std::move(params);
  message.sinks = {std::move(module)};
  message.session = context_.options.session;
  message.correlation = context_.next_id();
  message.rounds = inbox_.rounds() + 1;
  const auto correlation = message.correlation;
  const auto timeout = context_.program->settings.sessions.request_timeout;
  context_.turns.asked(correlation, turn, context_.now + timeout.count(),
                       meaning);
  for (auto& event : context_.port.post(std::move(message))) {
    inbox_.add_internal(
        {.message = std::make_shared<const Message>(std::move(event)),
         .turn = turn});
    context_.turns.answered(correlation);
  }
  return correlation;
}

void Messenger::post_for_another(Message message) {
  message.rounds = inbox_.rounds() + 1;
  context_.port.post(std::move(message));
}

bool Messenger::one_more_internal_event() {
  const auto count = inbox_.count_internal();
  if (count == Inbox::Count::just_above)
    script_failed({ErrorKind::limit,
                   "more than " + std::to_string(defaults::internal_events) +
                       " internal events without an external one; the rest is "
                       "dropped",
                   {}},
                  0);
  return count == Inbox::Count::within;
}

void Messenger::raise_error(const Error& error, TurnId turn) {
  raise("Script", "Error",
        {error.message, error.place.file, std::int64_t{error.place.line}},
        turn);
}

void Messenger::script_failed(const Error& error, TurnId turn) {
  context_.inspect(InspectionKind::error, std::string(name_of(error.kind)),
                   to_string(error));
  raise_error(error, turn);
}

} // namespace parlour::dialogue
