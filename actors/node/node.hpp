// Node: one running application: its components, its sessions, its time. What
// the tools use; no actor type shows here.
//
// One thread drives a node: start, open, enter, run_until_quiet, stop … are
// called from one thread at a time. interrupt() may come from any. In real time
// the actors run on threads of their own meanwhile; in virtual time they run on
// the driving thread, inside of these calls, and time stands still between
// them. Nodes do not know each other: many may run in one process.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actors/components/component_order.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/inspection.hpp"
#include "runtime/base/phrases.hpp"
#include "runtime/base/sockets.hpp"
#include "runtime/base/understanding.hpp"
#include "runtime/plugin/catalogue.hpp"
#include "runtime/plugin/plugin.hpp"
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/program/program.hpp"

namespace parlour::actors {

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
  // Of session ids and of what is random in scripts; nothing: chance.
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
  // One call at a time, from any thread; may be empty. What on_inspection
  // throws is logged; log may not throw.
  std::function<void(const Inspection&)> on_inspection;
  // What is private is masked in what on_inspection and log are given, and what
  // a user says is shown when it is understood. True: on_inspection is given
  // all at once and as it is, and shows nothing but by Node::masked().
  bool exact_inspections = false;
  // False: on_inspection hears of errors, logs and unhandled messages only,
  // and nobody pays for the rest.
  bool inspect_all = true;
  std::function<void(const std::string&)> log;
};

using SeatId = std::string;

// Called one at a time for each seat, in real time from threads of the node.
// They may not call the node; what they throw is logged.
struct SeatCallbacks {
  std::function<void(const SessionId&, const dialogue::Output&)> on_output;
  std::function<void(const SessionId&)> on_session_end;
};

// What went through since the start.
struct NodeCounters {
  std::uint64_t messages = 0;
  std::uint64_t relayed = 0;
  std::uint64_t filtered = 0;
  std::uint64_t dropped = 0;
  std::uint64_t unhandled = 0;
};

class Node {
public:
  // All components are up when this returns, or an error names the first that
  // does not start, and nothing runs.
  static Expected<std::unique_ptr<Node>> start(NodeOptions options);
  ~Node(); // stops, and leaves behind what does not

  SeatId open_seat(SeatCallbacks callbacks);
  // A conversation begins: Session.Started is handled and the opening prompt
  // released when this returns.
  SessionId open(const SeatId& seat);
  // The seat's session; empty where it has none.
  SessionId session_at(const SeatId& seat) const;
  // User turns, queued together (engine rule 3). Opens a session if the seat
  // has none.
  void enter(const SeatId& seat, const std::vector<std::string>& lines);
  // Any message, as it comes from a component.
  void inject(const SessionId& session, Message message);

  // Until nothing is queued or running, and in real time until no session
  // waits for an answer that is to come without a delay. False when
  // interrupted.
  bool run_until_quiet();
  // The next due time comes, if it is at most this far: virtual time jumps,
  // real time is waited for. Then until quiet. False where nothing is due until
  // then (time stands still), or when interrupted.
  bool step_to_next_due(Milliseconds at_most);
  // When the next timer of a session is due, components' delays aside.
  std::optional<Timestamp> next_timer() const;
  // That much time passes, with all that falls due in it.
  void advance(Milliseconds time);
  // From another thread or a signal's: ends waits at once, and those to come
  // until stop().
  void interrupt();

  Timestamp now() const;
  // Of a quiet node; unknown and empty for a session that is not there.
  Value slot_value(const SessionId& session, const std::string& topic,
                   const std::string& slot);
  std::string state(const SessionId& session);
  // Without what is private, in whatever session.
  std::string masked(const std::string& text) const;
  // Whether a user's words are not to be kept.
  bool is_private(const std::string& words) const;
  NodeCounters counters() const;

  // Components while it runs, as <load> and <unload> do it.
  Expected<void> load(const std::string& plugin, const std::string& name = {});
  Expected<void> unload(const std::string& name);

  void end(const SessionId& session);
  // Ends all sessions, then the components. Nothing runs afterwards, but where
  // it returns false: then a component or a callback has not returned within
  // the drain times. It keeps its threads and its memory, calls nobody any
  // more, and should not be waited for: the process had better end.
  bool stop();

private:
  class Implementation;
  explicit Node(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

} // namespace parlour::actors
