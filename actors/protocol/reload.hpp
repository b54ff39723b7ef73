// The messages by which a node goes over to changed scripts (engine rule 7.13).
// Part of the mailboxes of the supervisor, the session manager and sessions
// (interfaces.hpp).
//
//   node -> supervisor         change_environment; then those that have read
//                              the old one are loaded again
//   node -> session manager    reload_program
//   manager -> each session    change_program
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "actors/protocol/in_flight.hpp"

namespace parlour {
class PhraseEvaluator; // runtime/message/phrases.hpp
namespace script {
struct Program; // script/program/program.hpp
} // namespace script
} // namespace parlour

namespace parlour::actors {

struct PluginEnvironment; // actors/components/instance/plugin_environment.hpp
class ProgramChange;      // actors/sessions/program_change.hpp

// What becomes of the conversations that go on.
enum class ReloadMode : std::uint8_t {
  keep,     // each goes on where it is, as far as the scripts still have that
  restart,  // each begins again
  new_only, // each keeps its scripts to its end
};

// What became of them.
struct ReloadedSessions {
  std::size_t gone_over = 0; // they go on with the new scripts, or begin again
  std::size_t later = 0;     // as soon as they are at rest
  // "the state 'Welcome'": of so many conversations.
  std::map<std::string, std::size_t> lost;
};

// To the supervisor: this is what plug-ins see from now on.
struct change_environment {
  std::shared_ptr<const PluginEnvironment> environment;
  InFlight work;
};
// The components that have read what the scripts say of language, with their
// plug-ins.
struct environment_changed {
  std::map<std::string, std::string> readers;
};

// To the session manager: sessions are held with this program from now on. The
// answer tells of those that were there.
struct reload_program {
  std::shared_ptr<const script::Program> program;
  std::shared_ptr<const PhraseEvaluator> phrases;
  ReloadMode mode = ReloadMode::keep;
  InFlight work;
};
struct program_reloaded {
  ReloadedSessions sessions;
};

// To a session: go over, at once if at rest.
struct change_program {
  std::shared_ptr<const ProgramChange> change;
  InFlight work;
};
struct program_changed {
  bool has_ended = false; // nothing goes over any more
  bool later = false;     // something is going on that comes to its end first
  std::vector<std::string> lost = {};
};
// The time for that is over; a session sends this to itself.
struct scripts_over {
  std::shared_ptr<const ProgramChange> change;
};

} // namespace parlour::actors
