// The parser for conversation files, the tests of an application (docs/test.md,
// "Lines"). Each line is one step:
//
//   # comment                     clock 2026-11-21 09:00    seed 7
//   R: what the robot says        R~ a regular expression
//   U: what the user says         wait 3s
//   event SOURCE COMMAND param…   expect post MODULE COMMAND param…
//   expect slot Topic.Slot = value            expect state NAME
//   expect sql QUERY = value
//   P: what the user is just saying      B: [words heard] what the user says
//   U(voice=rms, noise=babble@20): …     expect first-sound < 1s
//
// `P:` is a partial result of the recogniser. `B:` is a barge-in: the user
// interrupts the robot's last output, of which only the words in brackets were
// heard (none without brackets). Without words of the user it is a noise, to
// which nothing is recognised. What the user says is typed, unless the line
// names a voice: then it is spoken, before a noise if there is one.
//
// Parameters and values are numbers, true, false, unknown, or text, which is
// quoted if it contains blanks. `*` as a parameter matches anything. `expect
// post` compares the parameters that it names; the message may have more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"
#include "script/source/findings.hpp"

namespace parlour::tools {

// The kinds of lines; `seed`, and `clock` before the first step, are fields of
// Conversation instead.
enum class StepKind : std::uint8_t {
  user,          // U:
  partial,       // P:
  barge_in,      // B:
  robot,         // R:
  robot_pattern, // R~
  wait,
  event,
  expect_post,
  expect_slot,
  expect_state,
  expect_sql,
  expect_first_sound,
  clock,
};

// One line. Its kind decides which fields are used.
struct Step {
  StepKind kind = StepKind::user;
  std::uint32_t line = 0;
  std::string written;       // the line itself, for reports
  std::string text;          // words, pattern, state, query or topic
  std::string target;        // source, module, slot or words heard
  std::string command;       // of an event or a post
  std::vector<Value> params; // of an event or a post
  Value value;               // the expected value
  Milliseconds duration{};   // of wait, and the most of first-sound
  Timestamp time = 0;        // of clock
  std::string voice;         // that speaks the user's line; empty: it is typed
  std::string noise;         // behind it
};

// A whole file: when it begins, its random seed and its steps.
struct Conversation {
  std::string file;
  std::string name; // the file's name without folder and ".txt"
  Timestamp start = 0;
  std::uint64_t seed = 1;
  std::vector<Step> steps;
};

// Whether a voice speaks one of its lines.
bool is_spoken(const Conversation& conversation);

// What the parser has made of a file. If there are errors, the conversation is
// incomplete and must not run.
struct ParsedConversation {
  Conversation conversation;
  std::vector<script::Finding> errors; // all errors of the file
};

// The start of a conversation without `clock`: 2026-11-21 09:00.
Timestamp default_start();

// Parses a text. `file` names it in errors and gives the conversation's name.
// Finds all errors, not only the first. Pure.
ParsedConversation parse_conversation(std::string_view text, std::string file);
// Reads and parses a file of at most 16 MB.
ParsedConversation read_conversation(const std::filesystem::path& file);

// A value as it is written in a file: "7" is a number, "'7'" text.
Value parse_literal(std::string_view text);
// Whether the value is `*`, which matches anything.
bool is_wildcard(const Value& value);

} // namespace parlour::tools
