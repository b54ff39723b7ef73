// A conversation as text: what `parlour test` holds against an application
// (docs/test.md, "Lines").
//
//   # comment                     clock 2026-11-21 09:00    seed 7
//   R: what the robot says        R~ a regular expression
//   U: what the user says         wait 3s
//   event SOURCE COMMAND param…   expect post MODULE COMMAND param…
//   expect slot Topic.Slot = value            expect state NAME
//   expect sql QUERY = value
//   P: what the user is just saying      B: [words heard] what the user says
//
// `P:` is a partial result: somebody is speaking. `B:` breaks in on what the
// robot said last, of which only the words in brackets were heard (without, no
// word); without anything after them it is a noise that nothing comes of.
// Parameters and values are numbers, true, false, unknown, or text, quoted
// where it has blanks; `*` as a parameter matches anything. Of `expect post`
// the parameters that are given are compared; a message may have more.
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

enum class StepKind : std::uint8_t {
  user,
  partial,
  barge_in,
  robot,
  robot_pattern,
  wait,
  event,
  expect_post,
  expect_slot,
  expect_state,
  expect_sql,
  clock,
};

// One line. Which fields count is said by its kind.
struct Step {
  StepKind kind = StepKind::user;
  std::uint32_t line = 0;
  std::string written;       // the line itself, for reports
  std::string text;          // words, pattern, state, query, slot's topic
  std::string target;        // source, module; slot's name; words heard
  std::string command;       // of an event or a post
  std::vector<Value> params; // of an event or a post
  Value value;               // expected
  Milliseconds duration{};   // of wait
  Timestamp time = 0;        // of clock
};

struct Conversation {
  std::string file;
  std::string name; // the file's, without its folder and ".txt"
  Timestamp start = 0;
  std::uint64_t seed = 1;
  std::vector<Step> steps;
};

struct ParsedConversation {
  Conversation conversation;
  std::vector<script::Finding> errors; // all of them
};

// The time at which a conversation begins that does not say another.
Timestamp default_start();

ParsedConversation parse_conversation(std::string_view text, std::string file);
ParsedConversation read_conversation(const std::filesystem::path& file);

// A number, true, false, unknown or text, quoted or not.
Value parse_literal(std::string_view text);
// The `*` that matches anything.
bool is_wildcard(const Value& value);

} // namespace parlour::tools
