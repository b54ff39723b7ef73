// Every actor's typed mailbox on one page, with a sentence for each message.
// Read it and you know who talks to whom (architecture, "The actors"). The
// messages stay on one node; what leaves the process is a parlour::Message. All
// understand tells_status, too (actor_status.hpp). `work`: the node is busy
// until the last handler that got it has returned (in_flight.hpp); what a
// handler sends holds work of its own. The only message with code says why.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <caf/allowed_unsafe_message_type.hpp>
#include <caf/replies_to.hpp>
#include <caf/typed_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/protocol/actor_status.hpp"
#include "actors/protocol/ask_component.hpp"
#include "actors/protocol/component_order.hpp"
#include "actors/protocol/due_times.hpp"
#include "actors/protocol/host_calls.hpp"
#include "actors/protocol/in_flight.hpp"
#include "actors/protocol/reload.hpp"
#include "actors/protocol/rest.hpp"
#include "actors/protocol/session_questions.hpp"
#include "actors/protocol/visits.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/metrics.hpp"
#include "runtime/base/outside/files.hpp"
#include "runtime/base/outside/sockets.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/subscription.hpp"

namespace parlour::dialogue {
struct FrameRequest; // script/dialogue/frame/topic_frame.hpp
struct FrameResult;
struct Output;       // script/dialogue/agenda/output_queue.hpp
struct SavedSession; // script/dialogue/inputs/saved_session.hpp
} // namespace parlour::dialogue

namespace parlour::actors {

// -- a session ----------------------------------------------------------------

// Session.Started: the first message that a session gets.
struct begin_session {
  InFlight work;
};
// Messages for this session; they are queued together and in this order.
struct deliver {
  std::vector<Message> messages;
  InFlight work;
  Nanoseconds arrived = 0; // as NodeMetrics::now() says; 0: just now
};
// Take the next queued input; the session sends this to itself.
struct take_step {
  InFlight work;
};
// A timer of this session is due.
struct timer_due {
  std::uint64_t id;
  InFlight work;
};
// Something that the session watches by the clock may be due; it sends this to
// itself.
struct wake_up {};
// The database's answer to a query of the session's script.
struct query_outcome {
  std::uint64_t id;
  Expected<Value> outcome; // a result set
  InFlight work;
};
// The outcome of a file operation of the session's script.
struct file_outcome {
  std::uint64_t id;
  Expected<Value> outcome;
  InFlight work;
};
// A socket of this session has opened, has received a text, or has closed.
struct socket_told {
  std::uint64_t id;
  SocketEvent event;
  InFlight work;
};
// The seat has finished an output. `played`: it was shown or spoken to its end.
struct output_done {
  std::uint64_t id;
  bool played;
  InFlight work;
};
// End the conversation: its Exit handlers run, and Session.Ended is fired.
struct end_session {
  InFlight work;
};
// The journal has this record and all before it: what the session wants, and
// waited for it, is done (engine rule 7.11).
struct record_written {
  std::uint64_t record;
  InFlight work;
};
// The session has ended, and nothing is on its way to it any more: quit.
struct leave {
  InFlight work;
};

using session_actor = caf::typed_actor<
    caf::reacts_to<begin_session>, caf::reacts_to<deliver>,
    caf::reacts_to<take_step>, caf::reacts_to<timer_due>,
    caf::reacts_to<wake_up>, caf::reacts_to<query_outcome>,
    caf::reacts_to<file_outcome>, caf::reacts_to<socket_told>,
    caf::reacts_to<output_done>, caf::replies_to<get_slot>::with<slot_told>,
    caf::replies_to<get_state>::with<state_told>, caf::reacts_to<end_session>,
    caf::reacts_to<record_written>,
    caf::replies_to<change_program>::with<program_changed>,
    caf::reacts_to<scripts_over>, caf::reacts_to<rest_if_idle>,
    caf::reacts_to<leave>, tells_status>;

// -- files --------------------------------------------------------------------

// A script reads or writes a file in the data folder; file_outcome follows.
struct file_order {
  std::uint64_t id;
  FileRequest request;
  session_actor session;
  InFlight work;
};
using file_keeper_actor =
    caf::typed_actor<caf::reacts_to<file_order>, tells_status>;

// -- the message centre -------------------------------------------------------

// The same from outside, with when they came: stamp and route them in order.
struct publish : deliver {};
// Messages that their sender has routed itself, as far as sessions get them.
struct distribute {
  std::vector<Message> messages;
  InFlight work;
};
// A session has ended and is in no directory any more. The centre answers with
// `leave`, which arrives after everything that the centre sent it before.
struct retire {
  session_actor session;
  InFlight work;
};

// A timer of a session is due: the session hears of it behind all that had come
// before. Else silence would seem to be over while words wait to be passed on.
struct ring {
  session_actor session;
  timer_due what;
};

using message_centre_actor =
    caf::typed_actor<caf::reacts_to<publish>, caf::reacts_to<distribute>,
                     caf::reacts_to<retire>, caf::reacts_to<ring>,
                     tells_status>;

// -- what a session spawns ----------------------------------------------------

// The topic frame's only request: a frame, and changes to apply to it in order.
struct apply_changes {
  std::shared_ptr<const dialogue::FrameRequest> request;
  InFlight work;
};
// The new frame, and for each change whether it was accepted.
struct frame_changed {
  std::shared_ptr<const dialogue::FrameResult> result;
  InFlight work;
};
using topic_frame_actor =
    caf::typed_actor<caf::replies_to<apply_changes>::with<frame_changed>,
                     tells_status>;

// The timer's delay is over; it sends this to itself.
struct timer_expired {};
// Cancel the timer: it quits and sends no timer_due.
struct cancel_timer {
  InFlight work;
};
using timer_actor =
    caf::typed_actor<caf::reacts_to<timer_expired>,
                     caf::reacts_to<cancel_timer>, tells_status>;

// The event by which a component answers the query's message.
struct component_event {
  Message event;
  InFlight work;
};
// The query's time is over; it sends this to itself.
struct give_up {};
using query_actor = caf::typed_actor<caf::reacts_to<component_event>,
                                     caf::reacts_to<give_up>, tells_status>;

// -- components ---------------------------------------------------------------

// Identifies one instance of a component; never used again. 0: none.
using InstanceId = std::uint64_t;

using component_host_actor =
    caf::typed_actor<caf::reacts_to<start_component>,
                     caf::reacts_to<mailbox_ready>, caf::reacts_to<run_after>,
                     caf::reacts_to<run_now>, caf::reacts_to<stop_component>,
                     tells_status>;

// -- seats --------------------------------------------------------------------

// Show or speak this output; output_done follows.
struct say {
  SessionId session;
  std::shared_ptr<const dialogue::Output> output;
  InFlight work;
};
// The seat's session is over. The next user turn opens another.
struct session_over {
  SessionId session;
  InFlight work;
};
// Another session has opened, for user turns that the last one did not read.
struct next_session {
  SessionId session;
  InFlight work;
};

using seat_actor =
    caf::typed_actor<caf::reacts_to<say>, caf::reacts_to<session_over>,
                     caf::reacts_to<next_session>, caf::reacts_to<turns_done>,
                     caf::reacts_to<leave_seat>, tells_status>;

// To the supervisor and the session manager: a seat of this name has opened.
struct seat_opened {
  std::string name;
  seat_actor seat;
  InFlight work;
};
// To the supervisor: nobody will be there any more, and its session has ended.
struct seat_closed : seat_opened {};

// -- the supervisor -----------------------------------------------------------

// Load a component, replacing any running one of the same name. `rank`: its
// place in the order of preference, from 1; 0: that of the one it replaces,
// else last.
struct load_component {
  std::shared_ptr<const ComponentOrder> order;
  std::size_t rank;
  InFlight work;
};
// The same for a script; an empty `name` is the plug-in's.
struct load_plugin {
  std::string plugin;
  std::string name;
  InFlight work;
};
struct unload_component {
  std::string name;
  InFlight work;
};
// The answer to these three, when the instances have started, failed to, or are
// gone. It holds no work: a session that asked is counted as one that waits.
struct component_done {
  Expected<void> outcome;
};
// Of who answers later; may be empty.
using component_promise = caf::typed_response_promise<component_done>;
// Stop all components and start no more: the node is being stopped.
struct stop_components {
  InFlight work;
};
struct instance_started {
  InstanceId instance;
  Expected<void> outcome;
  InFlight work;
};
struct instance_stopped {
  InstanceId instance;
  InFlight work;
};
// An instance threw, flooded, or is broken. 0: one called in a session's turn.
struct component_failed {
  std::string name;
  InstanceId instance;
  std::string reason;
  InFlight work;
};
// An instance says whether it can take messages now (PluginHost::available).
struct component_available {
  InstanceId instance;
  bool is_available;
  InFlight work;
};
// Watch the calls of an instance. `begins`: the host has begun a call that
// nobody watches; otherwise the supervisor reminds itself to look at it.
struct watch_instance {
  InstanceId instance;
  bool begins;
};
// A draining instance has finished its last message.
struct instance_idle {
  InstanceId instance;
  InFlight work;
};
// The pause after a failure is over: start another instance. `scope` names the
// session or seat, and is empty for the node's. An outdated `trial` is ignored.
struct try_again {
  std::string name;
  std::string scope;
  std::uint64_t trial;
};
// The time of a departure is over: stop its instances even if they are busy.
struct drain_over {
  std::uint64_t departure;
};

// A session asks for its own instances of components before it begins. Answered
// when messages find their mailboxes; the instances may still be starting.
struct session_begins {
  SessionId session;
  InFlight work;
};
struct session_settled {};
// A session has ended: its own instances drain and stop.
struct session_ended {
  SessionId session;
  seat_actor seat;
  InFlight work;
};

using supervisor_actor = caf::typed_actor<
    caf::replies_to<load_component>::with<component_done>,
    caf::replies_to<load_plugin>::with<component_done>,
    caf::replies_to<unload_component>::with<component_done>,
    caf::reacts_to<stop_components>, caf::reacts_to<instance_started>,
    caf::reacts_to<instance_stopped>, caf::reacts_to<component_failed>,
    caf::reacts_to<component_available>, caf::reacts_to<watch_instance>,
    caf::reacts_to<instance_idle>, caf::reacts_to<try_again>,
    caf::reacts_to<ask_component>, caf::reacts_to<drain_over>,
    caf::reacts_to<seat_opened>, caf::reacts_to<seat_closed>,
    caf::replies_to<session_begins>::with<session_settled>,
    caf::reacts_to<session_ended>,
    caf::replies_to<change_environment>::with<environment_changed>,
    tells_status>;

// -- sessions of a node -------------------------------------------------------

// Begin a conversation at a seat, unless one is going on there. The answer is
// the session's id, which is empty while the node is stopping.
struct open_session {
  seat_actor seat;
  InFlight work;
  // One that goes on after a crash, under its id; null: a new one.
  std::shared_ptr<const dialogue::SavedSession> saved = nullptr;
};
struct session_opened {
  SessionId session;
};
// Messages for one session that their sender could not find or that has ended;
// messages without a session: for every session that wants them.
struct forward {
  std::vector<Message> messages;
  InFlight work;
};
// Of messages without a session, this one wants exactly these.
struct subscribe {
  SessionId session;
  std::vector<Subscription> to;
  InFlight work;
};
// End one session. An empty id ends every session, and none opens afterwards.
struct close_session {
  SessionId session;
  InFlight work;
};
// A session has ended. User turns that it did not read begin the next one.
struct session_gone {
  SessionId session;
  InFlight work;
  std::vector<Message> unread = {};
};

using session_manager_actor = caf::typed_actor<
    caf::replies_to<open_session>::with<session_opened>,
    caf::reacts_to<forward>, caf::reacts_to<subscribe>,
    caf::reacts_to<close_session>, caf::reacts_to<session_gone>,
    caf::reacts_to<seat_opened>, caf::reacts_to<begin_visit>,
    caf::reacts_to<end_visit>, caf::reacts_to<look_for_idle>,
    caf::replies_to<reload_program>::with<program_reloaded>, tells_status>;

} // namespace parlour::actors

#define X(name) CAF_ALLOW_UNSAFE_MESSAGE_TYPE(parlour::actors::name)
#include "actors/protocol/local_messages.def"
