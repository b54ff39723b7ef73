// WireError says what is wrong with a message of a remote agent
// (adapters/agents/PROTOCOL.md 5). Its kind decides whether the connection goes
// on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace parlour::adapters::agents {

enum class WireErrorKind : std::uint8_t {
#define X(name, closes, sentence) name,
#include "adapters/agents/wire/wire_errors.def"
#undef X
};

// The name of the kind in an `error` message.
std::string_view name_of(WireErrorKind kind);
// The kind of that name; nothing for a kind of a later version.
std::optional<WireErrorKind> error_kind_of(std::string_view name);

struct WireError {
  WireErrorKind kind = WireErrorKind::malformed;
  // What is wrong, for the person who reads the agent's log.
  std::string sentence;
  // The connection is closed although errors of this kind let it go on: what
  // follows cannot be told from the rest of this message.
  bool loses_track = false;

  bool operator==(const WireError&) const = default;
};

// Whether the connection is closed after this error.
bool closes_connection(const WireError& error);

// The beginning of a text that is shown in a sentence: at most so many bytes,
// cut between two characters.
std::string excerpt(std::string_view text, std::size_t bytes = 64);

template <class T>
using Read = tl::expected<T, WireError>;

// `sentence` says what is wrong and, if that helps, what would be right.
inline tl::unexpected<WireError> malformed(std::string sentence) {
  return tl::make_unexpected(
      WireError{WireErrorKind::malformed, std::move(sentence)});
}
inline tl::unexpected<WireError> oversized(std::string sentence) {
  return tl::make_unexpected(
      WireError{WireErrorKind::oversized, std::move(sentence)});
}

} // namespace parlour::adapters::agents
