// NodeOptions: what a node is made with: the program, the components, how time
// passes, and who watches.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actors/protocol/component_order.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/outside/files.hpp"
#include "runtime/base/outside/journal.hpp"
#include "runtime/base/outside/sockets.hpp"
#include "runtime/message/inspection.hpp"
#include "runtime/message/phrases.hpp"
#include "runtime/message/understanding.hpp"
#include "runtime/plugin/catalogue.hpp"
#include "runtime/plugin/plugin.hpp"
#include "script/program/program.hpp"

namespace parlour::actors {

// Filled by tools/parlour/application from the settings and the command line. A
// test needs `program` alone.
struct NodeOptions {
  std::shared_ptr<const script::Program> program;
  // One whose scope has 0 instances is not started: it is for <load>.
  std::vector<ComponentOrder> components;
  // What scripts can load; without, they are refused it.
  std::shared_ptr<PluginCatalogue> plugins = {};
  // Completes what is loaded, as the components above are: where it runs, say.
  std::function<void(ComponentOrder&)> complete = {};
  // Another name of a role: "Record" is "Microphone".
  std::map<std::string, std::string, std::less<>> aliases;
  std::shared_ptr<const PhraseEvaluator> phrases;
  // Null: the program's.
  std::shared_ptr<const UnderstandingModel> understanding;
  ColumnReader columns;
  // Virtual time from here; nothing: real time.
  std::optional<Timestamp> virtual_start;
  // Real time, but the clock shows this when the node is made.
  std::optional<Timestamp> real_start = {};
  // Of session ids and of what is random in scripts; nothing: by chance.
  std::optional<std::uint64_t> seed;
  std::string data_folder;        // absolute, writable
  std::string application_folder; // absolute
  unsigned threads = 0;           // of the scheduler; 0: as many as cores
  // How long sessions, then components, then the rest get to end in real time.
  Milliseconds drain_time{2'000};
  // How long a component may take to start, in real time: libraries and models
  // are loaded.
  Milliseconds start_time{30'000};
  // The files of the data folder and the network; without, scripts are refused
  // what wants them.
  FileAccess files = {};
  std::shared_ptr<Sockets> sockets = {};
  // Keeps what enters the sessions, so that they can be repeated; null: nobody
  // does.
  std::shared_ptr<Journal> journal = {};
  // What a session says and wants leaves it once the journal has what led to
  // it: nothing that anybody has heard is lost by a crash (engine rule 7.11).
  bool strict_journal = false;
  // One call at a time, from any thread; may be empty. What on_inspection
  // throws is logged; log may not throw.
  std::function<void(const Inspection&)> on_inspection;
  // What is private is masked in what on_inspection and log are given, and what
  // a user says is shown when it is understood. True: on_inspection is given
  // all at once and as it is, and shows nothing but by Node::masked().
  bool exact_inspections = false;
  // For tests: after each input a session's conversation is written, ended, and
  // another goes on from its bytes, if nothing but timers is outstanding with
  // another port (engine rules 7.8 and 7.9).
  bool restores_after_each_input = false;
  // False: on_inspection hears of errors, logs and unhandled messages only,
  // and nobody pays for the rest.
  bool inspect_all = true;
  // on_inspection hears of each message that these actors take: kinds such as
  // "session", or names: a component's, a seat's, a session's id.
  std::vector<std::string> trace_actors = {};
  std::function<void(const std::string&)> log;
};

} // namespace parlour::actors
