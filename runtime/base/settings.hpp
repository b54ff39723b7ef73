// The configuration of an application (settings.xml; docs/writing.md) as data.
// script/compiler/application/settings_reader reads it; defaults.hpp has every
// default.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/component_policy.hpp"
#include "runtime/base/defaults.hpp"
#include "runtime/base/error.hpp"

namespace parlour {

// A component: a plug-in under a name of its own.
struct ComponentSettings {
  std::string name;                           // "Desk2Mic"
  std::string plugin;                         // "AlsaMicrophone"
  std::map<std::string, std::string> options; // ${NAME} already replaced
  SourceLocation place;
  ComponentPolicy policy = {};
};

// A remote agent: a component that is a process of its own and connects by
// itself (docs/agents.md).
struct AgentSettings {
  std::string name = {};
  std::vector<std::string> roles = {}; // empty: those of the stand-in
  // How it proves that it is this agent; ${NAME} already replaced.
  std::string token = {};
  std::string key = {}; // for CURVE, as Z85 text
  // The plug-in that takes its place in tests and simulations; empty: nobody,
  // the agent is offline there.
  std::string stand_in = {};
  std::map<std::string, std::string> options = {}; // of the stand-in
  SourceLocation place = {};
};

// Where agents connect, and who may.
struct AgentsSettings {
  // "127.0.0.1:5671" for lines of text, and for ZeroMQ. Empty: not that way.
  std::string lines = defaults::agent_lines;
  std::string zeromq = defaults::agent_zeromq;
  // Where a copy of every message is published by ZeroMQ; empty: nowhere.
  std::string taps;
  // Files in PEM, relative to the application: lines need TLS off loopback.
  std::string certificate;
  std::string private_key;
  // ZeroMQ's secret key of the platform: needed off loopback.
  std::string secret_key;
  std::vector<AgentSettings> agents; // in order of preference
  SourceLocation place;
};

// Times of a session; the meaning of each is in defaults.hpp.
struct SessionSettings {
  Milliseconds resume_after = defaults::resume_after;
  Milliseconds no_input_after = defaults::no_input_after;
  Milliseconds context_for = defaults::context_for;
  Milliseconds request_timeout = defaults::request_timeout;
  Milliseconds rest_after = defaults::rest_after;
  Milliseconds closes_after = defaults::closes_after;
  // Where a journal is kept (engine rules 7.10 and 7.11).
  bool strict_journal = false;
  Milliseconds keep_journal = defaults::keep_journal;
};

// A place where one conversation at a time happens (engine rule 7.1). Which
// events open one there is among the openings of the program.
struct SeatSettings {
  // Which component, or remote agent, fills a role at this seat alone.
  struct Binding {
    std::string role;
    std::string component;
    SourceLocation place;
  };
  std::string name;
  std::vector<Binding> components = {};
  std::optional<Milliseconds> closes_after = {}; // nothing: the sessions'
  SourceLocation place = {};
};

// Null where no seat has that name.
const SeatSettings* find_seat(const std::vector<SeatSettings>& seats,
                              std::string_view name);

// Limits of a session's scripts (language rule 9.6).
struct Limits {
  std::uint64_t instructions = defaults::instructions; // per event
  std::uint32_t depth = defaults::depth;               // calls
  std::size_t bytes = defaults::session_bytes;         // held by a session
  std::size_t result = defaults::result_bytes;         // of one built-in
};

// Filled by the reader, immutable afterwards.
struct Settings {
  std::string name;
  std::string start;  // a state or topic; if empty: engine rule 4.6
  std::string folder; // the application's
  // Allows SQL that is built with '+' (language rule 11.2).
  bool unsafe_sql = false;
  std::vector<ComponentSettings> components; // in order of preference
  AgentsSettings agents;                     // preferred to components
  std::vector<std::string> scripts;          // relative to the folder
  std::vector<std::string> libraries;        // of the platform, such as phrases
  SessionSettings sessions;
  std::vector<SeatSettings> seats; // each of another name
  Limits limits;
};

} // namespace parlour
