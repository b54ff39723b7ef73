// Every actor's typed mailbox on one page, a sentence for each message. Read
// it and you know who talks to whom (architecture, "The actors"). The messages
// stay on one node; what leaves the process is a parlour::Message.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <caf/allowed_unsafe_message_type.hpp>
#include <caf/replies_to.hpp>
#include <caf/typed_actor.hpp>

#include "actors/protocol/work.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/message.hpp"
#include "runtime/base/sockets.hpp"
#include "runtime/base/subscription.hpp"

namespace parlour::dialogue {
class Conversation;
struct FrameRequest;
struct FrameResult;
struct Output;
} // namespace parlour::dialogue

namespace parlour::actors {

class DueTicket;       // actors/support/due_times.hpp
struct ComponentOrder; // actors/node/node.hpp

// -- a session ----------------------------------------------------------------

// Session.Started: the first message that a session gets.
struct begin_session {
  Work work;
};
// Messages for this session, together and in order.
struct deliver {
  std::vector<Message> messages;
  Work work;
};
// Take the next queued input; the session sends it to itself.
struct take_step {
  Work work;
};
// A timer of this session is due.
struct timer_due {
  std::uint64_t id;
  Work work;
};
// A query's outcome.
struct query_outcome {
  std::uint64_t id;
  Expected<ResultSet> outcome;
  Work work;
};
// What became of a file that a script wanted.
struct file_outcome {
  std::uint64_t id;
  Expected<Value> outcome;
  Work work;
};
// What became of a component that a script wanted to load or unload.
struct component_outcome {
  std::uint64_t id;
  Expected<void> outcome;
  Work work;
};
// A socket of this session is open, has a text, or is over.
struct socket_told {
  std::uint64_t id;
  SocketEvent event;
  Work work;
};
// The speaker or page is done with an output.
struct output_done {
  std::uint64_t id;
  bool played;
  Work work;
};
// Show your state to a test, the console or the trace.
struct look {
  std::function<void(const dialogue::Conversation&)> at;
  Work work;
};
// End: Exit runs, Session.Ended is fired.
struct end_session {
  Work work;
};
// It has ended and nothing more is on its way to it: go.
struct leave {
  Work work;
};

using session_actor = caf::typed_actor<
    caf::reacts_to<begin_session>, caf::reacts_to<deliver>,
    caf::reacts_to<take_step>, caf::reacts_to<timer_due>,
    caf::reacts_to<query_outcome>, caf::reacts_to<file_outcome>,
    caf::reacts_to<component_outcome>, caf::reacts_to<socket_told>,
    caf::reacts_to<output_done>, caf::reacts_to<look>,
    caf::reacts_to<end_session>, caf::reacts_to<leave>>;

// -- files --------------------------------------------------------------------

// A session's script wants something of a file in the data folder; file_outcome
// follows. One actor does them all, on a thread of its own, so that no session
// waits for the disk and no two write at once.
struct file_order {
  std::uint64_t id;
  FileRequest request;
  session_actor session;
  Work work;
};

using file_keeper_actor = caf::typed_actor<caf::reacts_to<file_order>>;

// -- the message centre -------------------------------------------------------

// Messages from outside that happened together: stamped, routed and counted in
// this order.
struct publish {
  std::vector<Message> messages;
  Work work;
};
// What is left for sessions of messages that their sender has routed itself.
struct distribute {
  std::vector<Message> messages;
  Work work;
};
// A session has ended and can no longer be found. What was sent to it before
// is in its mailbox when the centre lets it go.
struct retire {
  session_actor session;
  Work work;
};

using message_centre_actor =
    caf::typed_actor<caf::reacts_to<publish>, caf::reacts_to<distribute>,
                     caf::reacts_to<retire>>;

// -- what a session spawns ----------------------------------------------------

// The topic frame's only request: what happened to it, in order.
struct apply_changes {
  std::shared_ptr<const dialogue::FrameRequest> request;
  Work work;
};
// The new frame and what became of each change.
struct frame_changed {
  std::shared_ptr<const dialogue::FrameResult> result;
  Work work;
};

using topic_frame_actor =
    caf::typed_actor<caf::replies_to<apply_changes>::with<frame_changed>>;

// A timer's own alarm.
struct ring {};
// Forget it: no timer_due will come.
struct cancel_timer {
  Work work;
};

using timer_actor =
    caf::typed_actor<caf::reacts_to<ring>, caf::reacts_to<cancel_timer>>;

// The database component's answer to a query's message.
struct component_event {
  Message event;
  Work work;
};
// No answer came within the query's time.
struct give_up {};

using query_actor =
    caf::typed_actor<caf::reacts_to<component_event>, caf::reacts_to<give_up>>;

// -- components ---------------------------------------------------------------

// Names one instance of a component; never given again.
using InstanceId = std::uint64_t;
// How a wish ended; called once, on the supervisor's thread.
using Done = std::function<void(Expected<void>)>;

// Make and start the plug-in; instance_started follows.
struct start_component {};
// Something is in the component's mailbox
// (actors/routing/component_mailbox.hpp).
struct work_waits {};
// Work that the plug-in asked for later; `due` is its entry among the due
// times, which goes with the message where nobody takes it.
struct run_after {
  Milliseconds delay;
  std::shared_ptr<const DueTicket> due;
  std::function<void()> action;
  Work work;
};
// The delay of a run_after is over.
struct run_now {
  std::shared_ptr<const DueTicket> due;
  std::function<void()> action;
};
// Stop the plug-in and end; instance_stopped follows.
struct stop_component {};

using component_host_actor =
    caf::typed_actor<caf::reacts_to<start_component>,
                     caf::reacts_to<work_waits>, caf::reacts_to<run_after>,
                     caf::reacts_to<run_now>, caf::reacts_to<stop_component>>;

// -- seats --------------------------------------------------------------------

// The robot says something at this seat.
struct say {
  SessionId session;
  std::shared_ptr<const dialogue::Output> output;
  Work work;
};
// The seat's session is over; the next turn opens another.
struct session_over {
  SessionId session;
  Work work;
};
// Another has opened by itself, for turns that the last one did not come to.
struct next_session {
  SessionId session;
  Work work;
};

using seat_actor =
    caf::typed_actor<caf::reacts_to<say>, caf::reacts_to<session_over>,
                     caf::reacts_to<next_session>>;

// To the supervisor and the session manager: a seat is there, by this name.
struct seat_opened {
  std::string name;
  seat_actor seat;
  Work work;
};

// -- the supervisor -----------------------------------------------------------

// Load a component, or put it in the place of the one of its name.
// `rank`: its place in the order of preference, from 1; 0: after all others, or
// that of the one whose place it takes.
struct load_component {
  std::shared_ptr<const ComponentOrder> order;
  std::size_t rank;
  Done done;
  Work work;
};
// The same by names alone, as a script does: the plug-in's and the component's.
struct load_plugin {
  std::string plugin;
  std::string name;
  Done done;
  Work work;
};
struct unload_component {
  std::string name;
  Done done;
  Work work;
};
// Stop all, and start none any more.
struct stop_components {
  Work work;
};
struct instance_started {
  InstanceId instance;
  Expected<void> outcome;
  Work work;
};
struct instance_stopped {
  InstanceId instance;
  Work work;
};
// It threw, or says itself that it is broken. Instance 0: it was called in a
// session's turn.
struct component_failed {
  std::string name;
  InstanceId instance;
  std::string reason;
  Work work;
};
// A call of it began, the first since nobody watched; else: look whether its
// calls return in time.
struct watch_instance {
  InstanceId instance;
  bool begins;
};
// One that is to go has nothing to do any more.
struct instance_rests {
  InstanceId instance;
  Work work;
};
// A component that failed is tried again; `place`: the session or seat whose it
// is, if it is one's.
struct try_again {
  std::string name;
  std::string place;
  std::uint64_t trial;
};
// Those that are to go have had their time.
struct drain_over {
  std::uint64_t departure;
};

// A session asks for what it has of components before it begins: answered when
// messages for them find their way; their instances may still be starting.
struct session_begins {
  SessionId session;
  Work work;
};
struct session_settled {};
// Its own instances go, once they have done what they were given.
struct session_ended {
  SessionId session;
  seat_actor seat;
  Work work;
};

using supervisor_actor = caf::typed_actor<
    caf::reacts_to<load_component>, caf::reacts_to<load_plugin>,
    caf::reacts_to<unload_component>, caf::reacts_to<stop_components>,
    caf::reacts_to<instance_started>, caf::reacts_to<instance_stopped>,
    caf::reacts_to<component_failed>, caf::reacts_to<watch_instance>,
    caf::reacts_to<instance_rests>, caf::reacts_to<try_again>,
    caf::reacts_to<drain_over>, caf::reacts_to<seat_opened>,
    caf::replies_to<session_begins>::with<session_settled>,
    caf::reacts_to<session_ended>>;

// -- sessions of a node -------------------------------------------------------

// A conversation begins at a seat, unless one is going on there; answered with
// its session's id, which is empty when the house is closing.
struct open_session {
  seat_actor seat;
  Work work;
};
struct session_opened {
  SessionId session;
};
// Messages for one session that the sender found no handle of, or that has
// ended; without a session: for all that want them.
struct forward {
  std::vector<Message> messages;
  Work work;
};
// What a session hears of messages without one: these, and no others.
struct subscribe {
  SessionId session;
  std::vector<Subscription> to;
  Work work;
};
// End one session, or for an empty id every session: none opens afterwards.
struct close_session {
  SessionId session;
  Work work;
};
// A session ended. User turns that it was given and did not read begin the
// seat's next session.
struct session_gone {
  SessionId session;
  Work work;
  std::vector<Message> unread = {};
};

using session_manager_actor =
    caf::typed_actor<caf::replies_to<open_session>::with<session_opened>,
                     caf::reacts_to<forward>, caf::reacts_to<subscribe>,
                     caf::reacts_to<close_session>,
                     caf::reacts_to<session_gone>, caf::reacts_to<seat_opened>>;

} // namespace parlour::actors

// clang-format off
#define PARLOUR_LOCAL_MESSAGES(X) \
  X(publish) X(distribute) X(retire) X(begin_session) X(deliver) X(take_step) \
  X(timer_due) X(query_outcome) X(file_outcome) X(component_outcome) \
  X(socket_told) X(file_order) X(output_done) X(look) X(end_session) \
  X(leave) X(apply_changes) X(frame_changed) X(ring) X(cancel_timer) \
  X(component_event) X(give_up) X(start_component) X(work_waits) \
  X(run_after) X(run_now) X(stop_component) X(load_component) \
  X(load_plugin) X(unload_component) X(stop_components) X(instance_started) \
  X(instance_stopped) X(component_failed) X(watch_instance) \
  X(instance_rests) X(try_again) X(drain_over) X(seat_opened) \
  X(session_begins) X(session_settled) X(session_ended) X(say) \
  X(session_over) X(next_session) X(open_session) X(session_opened) \
  X(forward) X(subscribe) X(close_session) X(session_gone)
// clang-format on

#define X(name) CAF_ALLOW_UNSAFE_MESSAGE_TYPE(parlour::actors::name)
PARLOUR_LOCAL_MESSAGES(X)
#undef X
#undef PARLOUR_LOCAL_MESSAGES
