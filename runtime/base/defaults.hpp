// Every default of the platform, with a sentence for each.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/base/clock.hpp"

namespace parlour::defaults {

using namespace std::chrono_literals;

// Silence after which an unfinished topic is resumed.
inline constexpr Milliseconds resume_after = 2s;
// Silence after a question that counts as no input.
inline constexpr Milliseconds no_input_after = 8s;
// How long after speech was detected its words may take to arrive.
inline constexpr Milliseconds speech_without_words = 2s;
// How long an answered enquiry stays the context of elliptical questions.
inline constexpr Milliseconds context_for = 2min;
// How long a request waits for its reply.
inline constexpr Milliseconds request_timeout = 10s;
// How long one call into a component may take.
inline constexpr Milliseconds component_deadline = 10s;
// Idle time after which a session is written out.
inline constexpr Milliseconds rest_after = 5min;
// Idle time after which a seat's session ends.
inline constexpr Milliseconds closes_after = 60s;
// How long a finished part of a journal is kept.
inline constexpr Milliseconds keep_journal = 24h * 7;

// Where remote agents connect: lines of text, and ZeroMQ.
inline constexpr const char* agent_lines = "127.0.0.1:5671";
inline constexpr const char* agent_zeromq = "127.0.0.1:5672";

// Instructions that one event may execute before its script is ended.
inline constexpr std::uint64_t instructions = 1'000'000;
// The same for `parlour exec`.
inline constexpr std::uint64_t exec_instructions = 500'000'000;
// Function calls inside of each other.
inline constexpr std::uint32_t depth = 1'000;
// Bytes that the values of one session may hold.
inline constexpr std::size_t session_bytes = 16 << 20;
// Bytes that the result of one built-in may hold.
inline constexpr std::size_t result_bytes = 1 << 20;
// Instructions after which a script yields to other sessions.
inline constexpr std::uint32_t slice = 10'000;

// Internal events in a row without an external one (engine rule 2.6).
inline constexpr int internal_events = 100;

// Confidence below which a value is rejected, confirmed explicitly, or echoed
// (engine rule 5.5).
inline constexpr double reject_below = 0.4;
inline constexpr double confirm_below = 0.7;
inline constexpr double mark_below = 0.9;

} // namespace parlour::defaults
