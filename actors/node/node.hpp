// Node: one running application: its components, its sessions, its time. What
// the tools use; no actor type shows here.
//
// One thread drives a node: start, open, enter, run_until_quiet, stop … are
// called from one thread at a time. interrupt() may come from any. In real time
// the actors run on threads of their own meanwhile; in virtual time they run on
// the driving thread, inside of these calls, and time stands still between
// them. Another thread that has asked for status, metrics or a reload ends
// before stop(), as CAF's logger belongs to it, too. Nodes do not know each
// other: many may run in one process.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actors/node/changed_application.hpp"
#include "actors/node/node_options.hpp"
#include "actors/protocol/actor_status.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/metrics.hpp"
#include "runtime/message/message.hpp"
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/inputs/saved_session.hpp"

namespace parlour::actors {

using SeatId = std::string;

// Called one at a time for each seat, in real time from threads of the node.
// They may not call the node; what they throw is logged.
struct SeatCallbacks {
  std::function<void(const SessionId&, const dialogue::Output&)> on_output;
  std::function<void(const SessionId&)> on_session_end;
  // A session has begun by begin_visit(), or by itself for turns that the last
  // one left unread. It has said nothing yet.
  std::function<void(const SessionId&)> on_session_begin = {};
  // The turns with numbers up to this one are answered, as far as no time has
  // to pass for it.
  std::function<void(const SessionId&, std::uint64_t turn)> on_turns_done = {};
};

// What went through since the start.
struct NodeCounters {
  std::uint64_t messages = 0;
  std::uint64_t relayed = 0;
  std::uint64_t filtered = 0;
  std::uint64_t dropped = 0;
  std::uint64_t unhandled = 0;
};

// A conversation by hand: start(), open_seat(), open(), then for each line
// enter() and run_until_quiet(); what the robot says comes by on_output.
// step_to_next_due() lets silence pass. The tools' drivers do just that
// (tools/parlour).
class Node {
public:
  // All components are up when this returns, or an error names the first that
  // does not start, and nothing runs.
  static Expected<std::unique_ptr<Node>> start(NodeOptions options);
  ~Node(); // stops, and leaves behind what does not

  // A seat that stays until the node ends; no conversation begins yet. It is
  // the first configured one that nobody was given, whose components are there
  // then, or a new one where none is left. A configured seat exists from the
  // start under its name, also where nobody asks for it.
  SeatId open_seat(SeatCallbacks callbacks);
  // A conversation begins: Session.Started is handled when this returns, and
  // the opening prompt released as far as no other component words it. In
  // virtual time that has done so, too, and the seat has been told.
  SessionId open(const SeatId& seat);
  // The same for one that a crash has left (engine rule 7.11): what it asked
  // last is asked again. Empty where the seat has a session, or one of that id
  // is there.
  SessionId go_on(const SeatId& seat, dialogue::SavedSession saved);
  // The seat's session; empty where it has none.
  SessionId session_at(const SeatId& seat) const;
  // User turns, queued together (engine rule 3). Opens a session if the seat
  // has none.
  void enter(const SeatId& seat, const std::vector<std::string>& lines);

  // -- visits: seats that come and go. In real time these may be called from
  // any thread, and nobody waits

  // Opens a seat, where a conversation begins; on_session_begin tells.
  // One that a crash has left goes on (engine rule 7.11).
  SeatId begin_visit(SeatCallbacks callbacks,
                     std::optional<dialogue::SavedSession> left = {});
  // A numbered turn, in one line or several, for the session that has begun
  // there; nothing happens where there is none. Numbers rise, from 1.
  void enter_turn(const SeatId& seat, std::uint64_t number,
                  const std::vector<std::string>& lines);
  // The seat's session ends, and the seat is forgotten. What the session still
  // says is told, and its end last.
  void end_visit(const SeatId& seat);

  // Any message, as it comes from a component.
  // An empty session: for every session that listens or has subscribed to it
  // (engine rule 1d).
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
  // What it counts (docs/operations.md). Of actors that do not answer within
  // `patience` (real time) it is told that they do not. In real time this may
  // be called from any thread, as long as the node is not stopped.
  Metrics metrics(Milliseconds patience = default_patience);
  // Whether on_inspection hears of everything from now on, whatever
  // NodeOptions::inspect_all says. From any thread.
  void watch_all(bool wanted);
  // How every actor is; who does not answer within `patience` (real time) is
  // told as such, with the call that it is in. In real time this may be called
  // from any thread, as long as the node is not stopped.
  std::vector<ActorStatus> status(Milliseconds patience = default_patience);
  static constexpr Milliseconds default_patience{500};

  // Components while it runs, as <load> and <unload> do it.
  Expected<void> load(const std::string& plugin, const std::string& name = {});
  // An error where no component has the name; returns when it has stopped.
  Expected<void> unload(const std::string& name);

  // The application is changed (engine rule 7.13): components whose settings
  // are others, or who know the scripts, are loaded again; then conversations
  // go over as `mode` says. An error leaves all as it was: a component does not
  // start, or the program has private values where none had any. One change at
  // a time. In real time this may be called from any thread, as long as the
  // node is not stopped.
  Expected<ReloadOutcome> reload(ChangedApplication to, ReloadMode mode);

  // Asks it to end, and does not wait; an unknown or empty session is ignored.
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
