// What a message asks of a database, and what every database answers to it
// with the same words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "adapters/database/statement.hpp"
#include "runtime/base/message.hpp"

namespace parlour::adapters {

enum class DatabaseCommand : std::uint8_t {
  connect,
  query,
  begin,
  commit,
  rollback,
};

// Refused for a command that no database knows, Type for a query without SQL.
Expected<DatabaseCommand> command_of(const Message& message);

// A parameter, or unknown where it is missing.
const Value& param(const Message& message, std::size_t index);

// Whether the query may change something.
bool is_write(const Message& query);

// The parameters of the Result.
std::vector<Value> result_params(const Message& message,
                                 StatementAnswer answer);
// Those of the Error.
std::vector<Value> error_params(const Error& error);

// The answers to a transaction that is out of order.
Error already_begun();
Error not_begun(const Message& message);
Error rolled_back(const Message& message); // and its session was not told yet

Error database_closed();

} // namespace parlour::adapters
