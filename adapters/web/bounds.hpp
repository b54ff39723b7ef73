// The bounds of the text server: what a visitor may send and leave unread. What
// exceeds one is refused with a sentence, or ends the connection.
#pragma once

#include <cstddef>

namespace parlour::adapters::web {

// Enough for a page of text; what nobody says in a turn.
inline constexpr std::size_t max_message = 8 << 10; // bytes of a line or frame
inline constexpr std::size_t max_lines = 16;        // of one turn
// Turns of a session that are taken and not yet answered.
inline constexpr std::size_t max_open_turns = 8;
// What may wait to be sent to one visitor, in bytes.
// Some hundred outputs; more piles up only for who does not read.
inline constexpr std::size_t max_unsent = 256 << 10;
// What is kept of a session to be told again.
// A visitor who was away for a minute hears less than this. More of it for a
// thousand visitors would be memory that hardly anybody asks for.
inline constexpr std::size_t max_kept = 64;
inline constexpr std::size_t max_kept_bytes = 32 << 10;
// Connections that have no session, beside those that have one.
// They say hello or go within seconds (ServerOptions::patience).
inline constexpr std::size_t max_without_session = 1'000;
// A person types a few lines a second at most; programs are held to this.
inline constexpr unsigned messages_per_second = 200; // of one connection
inline constexpr std::size_t max_head = 8 << 10; // of a request for a WebSocket

} // namespace parlour::adapters::web
