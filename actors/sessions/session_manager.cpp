#include "actors/sessions/session_manager.hpp"

#include <algorithm>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/sessions/program_change.hpp"
#include "actors/sessions/seat.hpp"
#include "actors/sessions/session.hpp"
#include "actors/sessions/unaddressed.hpp"
#include "actors/support/actor_trace.hpp"
#include "actors/support/tell_status.hpp"
#include "runtime/message/roles.hpp"

namespace parlour::actors {

namespace {

using Self = session_manager_actor::stateful_pointer<session_manager_state>;

// -- opening ------------------------------------------------------------------

// Where sessions end faster than late turns come.
constexpr std::size_t max_departed = 1'000;

// The session is in the directory before it begins: what components say to it
// from its first word on finds it.
//
// Empty where the node stops, or where a session of that id goes on already. A
// seat that has a session keeps it: two lines that come at once open one.
SessionId open(Self self, const open_session& what, bool tells_seat = false) {
  auto& state = self->state;
  if (const auto* going_on = state.sessions.at(what.seat))
    return going_on->id;
  const auto& saved = what.saved;
  if (state.closing || (saved && state.sessions.find(saved->id)))
    return {};
  auto id = saved ? saved->id : state.names.next_id();
  auto session = self->spawn<caf::monitored>(
      actors::session, state.parts,
      SessionOrder{id, saved ? saved->seed : state.names.next_seed(), what.seat,
                   saved,
                   configured_name(what.seat, state.seats,
                                   state.parts->program->settings.seats)});
  auto& metrics = state.parts->observer.metrics();
  (saved ? metrics.sessions_recovered : metrics.sessions_opened).add();
  state.sessions.add(id, session, what.seat);
  if (tells_seat) // before the session can say anything
    self->send(what.seat, next_session{id, what.work});
  self->send(session, begin_session{what.work});
  return id;
}

// -- turns without a session --------------------------------------------------

// Null where the session is long over, or never was.
seat_actor last_seat_of(const session_manager_state& state,
                        const SessionId& session) {
  for (const auto& [id, seat] : state.departed)
    if (id == session)
      return seat;
  return {};
}

// Nobody reads these any more; they are counted and shown.
void leave_unhandled(MessageBus& bus, const std::vector<Message>& messages,
                     const char* why = "its session is over") {
  for (const auto& message : messages)
    bus.unhandled(message, why);
}

// User turns, or the message of an `<open>`: they are the first that the
// session gets after its beginning.
void bring(Self self, const seat_actor& seat, std::vector<Message> turns,
           const InFlight& work) {
  auto& state = self->state;
  const bool opens = !state.sessions.at(seat);
  const auto id = open(self, {seat, work});
  if (id.empty())
    return leave_unhandled(state.parts->bus, turns);
  if (opens)
    self->send(seat, next_session{id, work});
  for (auto& turn : turns) {
    state.parts->observer.discretion().goes_on(turn.session, id);
    turn.session = id;
  }
  self->send(state.sessions.at(seat)->session, deliver{std::move(turns), work});
}

// What a session that is over will not read, or what a seat's own components
// say: these name the seat while it has no session, and what they say is the
// session's if one has begun meanwhile.
void take_further(Self self, const SessionId& session,
                  std::vector<Message> messages, const InFlight& work) {
  auto& state = self->state;
  auto& bus = state.parts->bus;
  const auto named = state.seats.find(session);
  const bool is_seat = named != state.seats.end();
  const auto seat = is_seat ? named->second : last_seat_of(state, session);
  if (!seat)
    return leave_unhandled(bus, messages);
  if (!is_seat)
    leave_unhandled(bus, take_others(messages, *bus.table(), {}));
  else if (!state.sessions.at(seat))
    leave_unhandled(bus, take_others(messages, *bus.table(), session),
                    "no conversation is going on at its seat");
  if (!messages.empty())
    bring(self, seat, std::move(messages), work);
}

// -- the end ------------------------------------------------------------------

void remember(session_manager_state& state, const SessionId& session,
              const seat_actor& seat) {
  state.departed.emplace_back(session, seat);
  if (state.departed.size() > max_departed)
    state.departed.pop_front();
}

// Nobody knows the seat any more, and nothing is on its way to it.
void dismiss(Self self, const std::string& name, const seat_actor& seat,
             const InFlight& work) {
  auto& state = self->state;
  std::erase_if(state.departed,
                [&](const auto& entry) { return entry.second == seat; });
  state.visits.erase(name);
  self->send(state.parts->supervisor, seat_closed{{name, seat, work}});
  self->send(seat, leave_seat{work});
}

// First nobody finds it any more; then the centre, which may have sent it
// something, lets it go; then its seat hears; last, its late turns open the
// seat's next session.
//
//   session -> manager   session_gone, with the turns it has not read
//   manager -> centre    retire: leave follows what the centre sent before
//   manager -> seat      session_over, then perhaps next_session
void forget(Self self, const session_gone& what) {
  auto& state = self->state;
  auto entry = state.sessions.remove(what.session);
  if (!entry)
    return;
  state.parts->observer.metrics().sessions_ended.add();
  auto& [id, session, seat, subscriptions] = *entry;
  self->send(state.parts->supervisor,
             session_ended{what.session, seat, what.work});
  state.parts->bus.retire(std::move(session), what.work);
  self->send(seat, session_over{what.session, what.work});
  if (auto closed = state.closing_seats.extract(seat.id()))
    dismiss(self, closed.mapped(), seat, what.work);
  else
    remember(state, what.session, seat);
  take_further(self, what.session, what.unread, what.work);
}

// A session that ended without a word: its actor was lost to an exception.
// Every session's end comes here; one that has said session_gone is not known
// any more.
void notice_loss(Self self, const caf::down_msg& down) {
  const auto* lost = self->state.sessions.find(down.source.id());
  if (!lost)
    return;
  const SessionId id = lost->id;
  auto& parts = *self->state.parts;
  auto& last_error = self->state.last_error;
  last_error =
      "session " + id + " was lost: " + self->system().render(down.reason);
  parts.observer.metrics().sessions_lost.add();
  parts.observer.log(last_error);
  forget(self, {id, parts.time.work.begin()});
}

// -- messages -----------------------------------------------------------------

// A sensor sees somebody, a robot has arrived: a conversation opens at each
// seat that has none, and gets the message (engine rule 1.8).
// True where it opened one: then the message was taken.
bool open_for(Self self, const Message& message, const RoutingTable& table,
              const InFlight& work) {
  auto& state = self->state;
  std::vector<std::string> names;
  for (const auto& [name, seat] : state.seats)
    if (!state.sessions.at(seat) && table.opens(message, name))
      names.push_back(name);
  std::ranges::sort(names); // so that equal runs open them in one order
  for (const auto& name : names)
    bring(self, state.seats.find(name)->second, {message}, work);
  return !names.empty();
}

// What the platform says goes to all, if anybody listens; what a component says
// to those who have subscribed, unless it answers somebody. From then on it
// belongs to the session.
void pass_to_all(Self self, Message message, const InFlight& work) {
  auto& bus = self->state.parts->bus;
  const auto table = bus.table();
  const auto* role = find_role(message.source);
  const bool raised = role && role->reserved;
  const bool listens =
      raised ? table->is_listened_to(message) : message.correlation == 0;
  bool taken = raised;
  for (const auto& [number, entry] : self->state.sessions.all())
    if (listens &&
        (raised || is_subscribed(entry.subscriptions, *table, message))) {
      message.session = entry.id;
      self->send(entry.session, deliver{{message}, work});
      taken = true;
    }
  if (message.correlation == 0)
    taken |= open_for(self, message, *table, work);
  if (!taken)
    bus.unhandled(message, "no session has subscribed to it");
}

// All of its subscriptions: they take the place of those before.
void note_subscriptions(Self self, const subscribe& what) {
  if (auto* found = self->state.sessions.find(what.session))
    found->subscriptions = what.to;
}

// All messages of one `forward` have the same session (message_centre.cpp);
// without one, each may be for several.
void pass_on(Self self, const forward& what) {
  if (what.messages.empty())
    return;
  const auto& id = what.messages.front().session;
  if (const auto* found = self->state.sessions.find(id))
    self->send(found->session, deliver{what.messages, what.work});
  else if (!id.empty())
    take_further(self, id, what.messages, what.work);
  else
    for (const auto& message : what.messages)
      pass_to_all(self, message, what.work);
}

void close(Self self, const close_session& what) {
  auto& state = self->state;
  if (!what.session.empty()) {
    if (const auto* found = state.sessions.find(what.session))
      self->send(found->session, end_session{what.work});
    return;
  }
  state.closing = true;
  for (const auto& [number, entry] : state.sessions.all())
    self->send(entry.session, end_session{what.work});
}

// -- visits -------------------------------------------------------------------

// Who has sent this may not spawn: CAF's logger would belong to that thread.
void begin(Self self, const begin_visit& what) {
  auto& state = self->state;
  if (state.closing)
    return;
  auto& parts = *state.parts;
  const auto seat = self->spawn<caf::linked>(
      actors::seat,
      SeatParts{&parts.time, &parts.observer, state.directory, what.name},
      *what.calls);
  state.visits[what.name] = seat;
  state.seats[what.name] = seat;
  self->send(parts.supervisor, seat_opened{what.name, seat, what.work});
  open(self, {seat, what.work, what.saved}, true);
}

// The seat lives until its session has ended: what that still says is told.
void end(Self self, const end_visit& what) {
  auto& state = self->state;
  const auto visit = state.visits.find(what.name);
  if (visit == state.visits.end())
    return;
  const auto seat = visit->second;
  state.seats.erase(what.name);
  const auto* session = state.sessions.at(seat);
  if (!session)
    return dismiss(self, what.name, seat, what.work);
  state.closing_seats[seat.id()] = what.name;
  self->send(session->session, end_session{what.work});
}

// -- rest ---------------------------------------------------------------------

void look_later(Self self) {
  auto& state = self->state;
  const auto idle = state.parts->program->settings.sessions.rest_after;
  self->delayed_send(self, state.resting.until_next(idle), look_for_idle{});
}

void send_to_rest(Self self) {
  auto& state = self->state;
  const auto idle = state.parts->program->settings.sessions.rest_after;
  for (const auto* entry : state.resting.next(state.sessions.all(), idle))
    self->send(entry->session, rest_if_idle{idle});
  look_later(self);
}

// -- another program ----------------------------------------------------------

using reload_promise = caf::typed_response_promise<program_reloaded>;

// Who opens from now on has the new program. A session that ends before it has
// answered is counted nowhere.
reload_promise reload(Self self, const reload_program& what) {
  auto& state = self->state;
  auto parts = std::make_shared<SessionParts>(*state.parts);
  parts->program = what.program;
  parts->phrases = what.phrases;
  state.parts = std::move(parts);
  auto promise = self->make_response_promise<program_reloaded>();
  auto reloading = std::make_shared<ReloadTally>(
      ReloadTally{[promise](program_reloaded told) mutable {
                    promise.deliver(std::move(told));
                  },
                  1});
  if (what.mode != ReloadMode::new_only) {
    reloading->left += state.sessions.all().size();
    const auto change =
        std::make_shared<const ProgramChange>(state.parts, what.mode);
    for (const auto& [number, entry] : state.sessions.all())
      self->request(entry.session, caf::infinite,
                    change_program{change, what.work})
          .then(
              [=](const program_changed& told) {
                reloading->take(told);
                reloading->one_less();
              },
              [=](const caf::error&) { reloading->one_less(); });
  }
  reloading->one_less();
  return promise;
}

std::vector<ActorHandle> visitors_of(const session_manager_state& state) {
  std::vector<ActorHandle> all;
  for (const auto& [name, seat] : state.visits)
    all.push_back(
        {seat_state::name, name, caf::actor_cast<caf::strong_actor_ptr>(seat)});
  std::ranges::sort(all, {}, &ActorHandle::name);
  return all;
}

} // namespace

session_manager_actor::behavior_type session_manager(
    session_manager_actor::stateful_pointer<session_manager_state> self,
    SessionParts parts, SessionDirectory* directory, SessionNames names) {
  parts.manager = session_manager_actor(self);
  self->state.parts = std::make_shared<const SessionParts>(std::move(parts));
  self->state.directory = directory;
  self->state.sessions = OpenSessions(*directory);
  self->state.names = std::move(names);
  self->set_down_handler(
      [=](const caf::down_msg& down) { notice_loss(self, down); });
  look_later(self);
  return traced<session_manager_actor::behavior_type>(
      ActorTrace(self->state.parts->observer, session_manager_state::name, ""),
      [=](const open_session& what) {
        return session_opened{open(self, what)};
      },
      [=](const forward& what) { pass_on(self, what); },
      [=](const subscribe& what) { note_subscriptions(self, what); },
      [=](const close_session& what) { close(self, what); },
      [=](const session_gone& what) { forget(self, what); },
      [=](const seat_opened& what) {
        self->state.seats[what.name] = what.seat;
      },
      [=](const begin_visit& what) { begin(self, what); },
      [=](const end_visit& what) { end(self, what); },
      [=](const look_for_idle&) { send_to_rest(self); },
      [=](const reload_program& what) { return reload(self, what); },
      [=](const get_status& what) {
        const auto& state = self->state;
        return tell_status(self, what,
                           {{},
                            std::to_string(state.sessions.all().size()) +
                                " sessions at " +
                                std::to_string(state.seats.size()) + " seats",
                            state.last_error,
                            what.with_children ? visitors_of(state)
                                               : std::vector<ActorHandle>()});
      });
}

} // namespace parlour::actors
