// The system configuration of an application (settings.xml; docs/writing.md)
// as data. Read by script/settings_reader; every default is stated in
// defaults.hpp.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/defaults.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/upkeep.hpp"

namespace parlour {

// One component instance: a plug-in under a name of its own.
struct ComponentSettings {
  std::string name;                           // "Desk2Mic"
  std::string plugin;                         // "AlsaMicrophone"
  std::map<std::string, std::string> options; // ${NAME} already replaced
  Place place;
  Upkeep upkeep = {};
};

struct SessionSettings {
  Milliseconds resume_after = defaults::resume_after;
  Milliseconds no_input_after = defaults::no_input_after;
  Milliseconds context_for = defaults::context_for;
  Milliseconds request_timeout = defaults::request_timeout;
  Milliseconds rest_after = defaults::rest_after;
  Milliseconds closes_after = defaults::closes_after;
};

struct Limits {
  std::uint64_t instructions = defaults::instructions; // per event
  std::uint32_t depth = defaults::depth;               // calls
  std::size_t bytes = defaults::session_bytes;         // held by a session
  std::size_t result = defaults::result_bytes;         // of one built-in
};

struct Settings {
  std::string name;
  std::string start;  // a state or a topic; empty: see engine rule 4.6
  std::string folder; // the application's
  bool unsafe_sql = false;
  std::vector<ComponentSettings> components; // in order of preference
  std::vector<std::string> scripts;          // relative to the folder
  std::vector<std::string> libraries;        // phrases and such of the platform
  SessionSettings sessions;
  Limits limits;
};

} // namespace parlour
