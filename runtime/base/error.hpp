// Error: what went wrong, as a value. A user's input causes an Error (a file, a
// message, a database that cannot be reached). It has a kind, a message that
// reads as a sentence and, if known, a position in a source file. Programming
// errors are asserts, never Errors.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace parlour {

// The closed set of kinds that a script can catch (language rule 9.5).
// clang-format off
#define PARLOUR_ERROR_KINDS(X) \
  X(type, "Type", "an operand or argument has the wrong type") \
  X(arithmetic, "Arithmetic", "a division by zero or an infinite result") \
  X(range, "Range", "a position or key outside of what there is") \
  X(thrown, "Thrown", "thrown by a script's <throw>") \
  X(timeout, "Timeout", "no answer came in time") \
  X(offline, "Offline", "nobody is there to take the message") \
  X(refused, "Refused", "the receiver said no") \
  X(cancelled, "Cancelled", "the wait was ended from outside") \
  X(in_doubt, "InDoubt", "whether it happened is not known") \
  X(database, "Database", "the database reported an error") \
  X(file, "File", "a file cannot be read or written") \
  X(network, "Network", "a connection failed") \
  X(limit, "Limit", "a limit of the settings was reached") \
  X(compile, "Compile", "the application's source has errors") \
  X(settings, "Settings", "the settings or the command line are wrong")
// clang-format on

enum class ErrorKind : std::uint8_t {
#define X(name, text, sentence) name,
  PARLOUR_ERROR_KINDS(X)
#undef X
};

// The kind's name as scripts see it in `.kind`.
std::string_view name_of(ErrorKind kind);

// A position in a source file. Line and column count from 1; 0 means unknown.
struct SourceLocation {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  bool operator==(const SourceLocation&) const = default;
};

// Immutable by convention; copied freely and sent between threads.
struct Error {
  ErrorKind kind = ErrorKind::thrown;
  std::string message;
  SourceLocation place;

  bool operator==(const Error&) const = default;
};

// "file:line: message", with as much of the place as is known.
std::string to_string(const Error& error);

// A function that a user's input can make fail returns Expected<T>:
//
//   Expected<Settings> read_settings(const fs::path& path) {
//     auto text = read_file(path);
//     if (!text)
//       return tl::make_unexpected(text.error());
//     …
//     return fail(ErrorKind::settings, "there is no <name>", {path, 3});
//   }
template <class T>
using Expected = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorKind kind, std::string message,
                                  SourceLocation place = {}) {
  return tl::make_unexpected(Error{kind, std::move(message), std::move(place)});
}

} // namespace parlour
