// The commands that every database component accepts, and the parts of the
// answers that are the same for every product. SQLiteDatabase and MySQLDatabase
// both use these functions, so that a script sees the same answers and the same
// error messages from either.
//
// The wire format is that of the role Database:
//
//  command                     answer
//  Connect(options)            Result()
//  Query(sql, values, write?)  Result(rows), or Result(rows, changes) if write
//  Begin, Commit, Rollback     Result()
//  any, if it fails            Error(kind, message)
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "adapters/database/statement.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters {

enum class DatabaseCommand : std::uint8_t {
  connect,
  query,
  begin,
  commit,
  rollback,
};

// Reads the command of a message. The error is Refused if the command is
// unknown, and Type if a Query has no text as its first parameter.
Expected<DatabaseCommand> command_of(const Message& message);

// The parameter at `index`, counted from 0, or unknown if the message has
// fewer. The reference is valid as long as the message.
const Value& param(const Message& message, std::size_t index);

// Whether the third parameter of a Query allows it to write (language rule
// 11.12).
bool is_write(const Message& query);

// The parameters of the Result that answers `message`. The number of changed
// rows is included only if `message` was allowed to write.
std::vector<Value> result_params(const Message& message,
                                 StatementAnswer answer);
// The parameters of the Error that reports `error`: its kind by name, and its
// message.
std::vector<Value> error_params(const Error& error);

// The errors for Begin, Commit and Rollback in the wrong order. `rolled_back`
// answers the first statement of a session whose transaction was rolled back
// while the session was not waiting for an answer.
Error already_begun();
Error not_begun(const Message& message);
Error rolled_back(const Message& message);

// The error for every message that the component had not answered when it
// stopped.
Error database_closed();

} // namespace parlour::adapters
