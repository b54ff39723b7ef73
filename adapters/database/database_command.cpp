#include "adapters/database/database_command.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace parlour::adapters {

Expected<DatabaseCommand> command_of(const Message& message) {
  using Command = DatabaseCommand;
  constexpr std::array<std::pair<std::string_view, Command>, 5> commands{
      {{"Query", Command::query},
       {"Begin", Command::begin},
       {"Commit", Command::commit},
       {"Rollback", Command::rollback},
       {"Connect", Command::connect}}};
  // Only Query has parameters that every database needs in the same form.
  for (const auto& [name, command] : commands) {
    if (message.command != name)
      continue;
    if (command == Command::query && !param(message, 0).if_string())
      return fail(ErrorKind::type, "Query needs SQL as its first parameter.");
    return command;
  }
  return fail(ErrorKind::refused, "A database does not know the command '" +
                                      message.command + "'.");
}

const Value& param(const Message& message, std::size_t index) {
  static const Value unknown;
  return index < message.params.size() ? message.params[index] : unknown;
}

bool is_write(const Message& query) {
  return static_cast<bool>(param(query, 2));
}

std::vector<Value> result_params(const Message& message,
                                 StatementAnswer answer) {
  // Commands other than Query change nothing that a script counts.
  const bool is_change = message.command == "Query" && is_write(message);
  std::vector<Value> params;
  params.reserve(is_change ? 2 : 1);
  params.emplace_back(std::move(answer.rows));
  if (is_change)
    params.emplace_back(answer.changes);
  return params;
}

std::vector<Value> error_params(const Error& error) {
  return {name_of(error.kind), error.message};
}

Error already_begun() {
  return {ErrorKind::database,
          "Begin: this conversation is in a transaction already.",
          {}};
}

Error not_begun(const Message& message) {
  return {ErrorKind::database,
          message.command + ": this conversation has no transaction.",
          {}};
}

Error rolled_back(const Message& message) {
  return {ErrorKind::database,
          message.command + ": the transaction was rolled back, as it took too "
                            "long or failed.",
          {}};
}

Error database_closed() {
  return {ErrorKind::offline, "The database was closed.", {}};
}

} // namespace parlour::adapters
