#include "actors/sessions/session_port.hpp"

#include <algorithm>
#include <utility>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/sessions/query.hpp"
#include "actors/sessions/timer.hpp"
#include "actors/sessions/topic_frame.hpp"
#include "actors/support/exception_text.hpp"

namespace parlour::actors {

SessionPort::SessionPort(session_actor::pointer self,
                         std::shared_ptr<const SessionParts> parts,
                         SessionId id, seat_actor seat, AskFrame ask_frame,
                         ComponentDone component_done)
    : self_(self), parts_(std::move(parts)), time_(parts_->time),
      bus_(parts_->bus), id_(std::move(id)), seat_(std::move(seat)),
      ask_frame_(std::move(ask_frame)),
      component_done_(std::move(component_done)),
      effects_(parts_->strict_journal), alarm_(self_, time_, bus_),
      sockets_(time_, parts_->sockets, session_actor(self_)) {}

// At once, where nothing has to wait for the journal.
template <class Effect>
void SessionPort::perform(Effect effect, HeldEffects::Noted noted) {
  effects_.perform(std::move(effect),
                   effects_.holds() ? time_.work.begin() : InFlight(), noted);
}

// -- messages -----------------------------------------------------------------

// A message for another session leaves by the bus; one for this session comes
// back at once, with what inline components answered.
std::vector<Message> SessionPort::post(Message message) {
  if (message.session.empty())
    message.session = id_;
  if (message.session == id_)
    return bus_.route(std::move(message), *this);
  perform([this, message = std::move(message)] { bus_.publish({message}); },
          HeldEffects::Noted::yes);
  return {};
}

// Where it is not taken then, its answer comes as that of a component does.
bool SessionPort::keep_back(const Target& target,
                            const SharedMessage& message) {
  if (!effects_.holds())
    return false;
  perform(
      [this, target, message] {
        if (auto answer = bus_.hand_over(target, {message, time_.work.begin()}))
          bus_.publish({std::move(*answer)});
      },
      HeldEffects::Noted::yes);
  return true;
}

void SessionPort::post_again(std::vector<Message> messages) {
  bus_.publish(std::move(messages));
}

// A component without state, in the session's own turn.
// If it throws, the message has a failed answer in the same turn, and the
// supervisor counts the failure against the component.
std::vector<Message> SessionPort::call(const Target& target,
                                       const Message& message) {
  if (parts_->observer.traces("inline", target.name))
    trace_of("inline", target.name).took("message", to_string(message));
  if (target.mailbox)
    target.mailbox->count_direct();
  std::vector<Answer> answers;
  if (auto reason =
          catch_to_string([&] { answers = target.direct->answers(message); })) {
    self_->send(parts_->supervisor,
                component_failed{target.name, 0, *reason, time_.work.begin()});
    return {failure_answer(target.name, message, *reason)};
  }
  std::vector<Message> events;
  for (auto& answer : answers) {
    Message event;
    event.source = target.name;
    event.command = std::move(answer.command);
    event.params = std::move(answer.params);
    event.session = message.session;
    event.correlation = message.correlation;
    event.rounds = message.rounds + 1;
    events.push_back(std::move(event));
  }
  return events;
}

void SessionPort::subscribe(const std::vector<Subscription>& all) {
  self_->send(parts_->manager, actors::subscribe{id_, all, time_.work.begin()});
}

bool SessionPort::reachable(const std::string& module) const {
  return bus_.table()->find(module, id_) != nullptr;
}

bool SessionPort::is_source(const std::string& module,
                            const std::string& source) const {
  return bus_.table()->is_source(module, source);
}

Reply SessionPort::reply_to_request(const Message& event) const {
  return bus_.table()->reply_to_request(event);
}

void SessionPort::release(const dialogue::Output& output) {
  perform([this, shown = std::make_shared<const dialogue::Output>(output)] {
    self_->send(seat_, say{id_, shown, time_.work.begin()});
  });
}

void SessionPort::tell_turns_done(std::uint64_t turn) {
  perform([this, turn] {
    self_->send(seat_, turns_done{id_, turn, time_.work.begin()});
  });
}

// In a strict session the time includes the wait for the disk: that is what the
// user waits for.
void SessionPort::count_turns(const TurnMeter::Answered& answered) {
  perform([this, answered] {
    auto& metrics = parts_->observer.metrics();
    const auto took = NodeMetrics::now() - answered.since;
    metrics.turns.add(answered.turns);
    for (std::uint64_t i = 0; i < answered.turns; ++i)
      metrics.turn_time.observe(took);
  });
}

// -- timers, queries ----------------------------------------------------------

Timestamp SessionPort::due_at(Milliseconds after) const {
  return time_.now() + after.count();
}

ActorTrace SessionPort::trace_of(const char* kind,
                                 const std::string& name) const {
  return {parts_->observer, kind, name, id_};
}

// A script's timer is an actor of its own, so that CAF's clock ends it; its due
// time is noted first, as virtual time must not jump over it.
// A timer of the same number is replaced. One that is overdue, as after a
// crash, fires at once.
void SessionPort::start_timer(dialogue::TimerId id, Timestamp due,
                              dialogue::TimerOwner owner) {
  cancel_timer(id);
  if (owner == dialogue::TimerOwner::engine)
    return alarm_.set(id, due);
  const auto after = std::max(due - time_.now(), Timestamp{0});
  auto entry = time_.due_times.add(due, DueTimes::Of::session);
  auto actor =
      self_->spawn(timer, &time_, &bus_, session_actor(self_),
                   TimerOrder{id, Milliseconds(after), entry,
                              trace_of(timer_state::name, std::to_string(id))});
  timers_.emplace(id, Timer{std::move(actor), entry});
}

void SessionPort::cancel_timer(dialogue::TimerId id) {
  alarm_.cancel(id);
  if (auto found = timers_.extract(id))
    end_timer(found.mapped());
}

void SessionPort::end_timer(const Timer& timer) {
  time_.due_times.remove(timer.due);
  caf::anon_send(timer.actor, actors::cancel_timer{time_.work.begin()});
}

void SessionPort::timer_is_over(dialogue::TimerId id) {
  timers_.erase(id);
}

void SessionPort::query(dialogue::QueryRequest request) {
  perform([this, request = std::move(request)]() mutable {
    start_query(std::move(request));
  });
}

void SessionPort::start_query(dialogue::QueryRequest request) {
  const auto id = request.id;
  const auto timeout = parts_->program->settings.sessions.request_timeout;
  auto due = time_.due_times.add(due_at(timeout), DueTimes::Of::session);
  QueryOrder order{id_, std::move(request), timeout, due, time_.work.begin()};
  auto actor = self_->spawn(actors::query, &time_, &bus_, session_actor(self_),
                            std::move(order));
  queries_.emplace(id, Query{std::move(actor), due});
}

void SessionPort::query_is_over(dialogue::QueryId id) {
  queries_.erase(id);
}

// -- components, files, sockets -----------------------------------------------

// No deadline: the supervisor answers when it is done, or has given up.
void SessionPort::component(dialogue::ComponentRequest request) {
  perform([this, request = std::move(request)]() mutable {
    order_component(std::move(request));
  });
}

// The supervisor's answer is no awaited one: the session goes on hearing
// messages while a component starts for up to 30 s.
void SessionPort::order_component(dialogue::ComponentRequest request) {
  auto hear = [id = request.id, done = component_done_](auto answer) {
    answer.then(
        [=](const actors::component_done& what) { done(id, what.outcome); },
        [=](const caf::error&) {
          done(id, fail(ErrorKind::cancelled, "the application stops"));
        });
  };
  const auto& supervisor = parts_->supervisor;
  if (request.load)
    hear(self_->request(supervisor, caf::infinite,
                        load_plugin{std::move(request.plugin),
                                    std::move(request.name),
                                    time_.work.begin()}));
  else
    hear(self_->request(
        supervisor, caf::infinite,
        unload_component{std::move(request.name), time_.work.begin()}));
}

void SessionPort::file(dialogue::QueryId id, FileRequest request) {
  perform([this, id, request = std::move(request)] {
    self_->send(
        parts_->file_keeper,
        file_order{id, request, session_actor(self_), time_.work.begin()});
  });
}

// The refusal comes as an event, like any failure to connect: the script waits
// for it.
void SessionPort::open_socket(dialogue::SocketRequest request) {
  const auto id = request.id;
  if (!sockets_.open(std::move(request)))
    self_->send(self_,
                socket_told{id,
                            {SocketEvent::Kind::failed,
                             "this run has no network, as its time is virtual"},
                            time_.work.begin()});
}

Expected<void> SessionPort::send_socket(dialogue::SocketId id,
                                        const std::string& text) {
  return sockets_.send(id, text);
}

void SessionPort::socket_taken(dialogue::SocketId id) {
  sockets_.taken(id);
}

void SessionPort::close_socket(dialogue::SocketId id) {
  sockets_.close(id);
}

void SessionPort::socket_is_over(dialogue::SocketId id) {
  sockets_.forget(id);
}

// The adapter stops reading when too many texts are not taken.
std::vector<Message> SessionPort::hear_socket(dialogue::SocketId id,
                                              const SocketEvent& event) {
  std::vector<Message> messages;
  if (auto message = sockets_.message(id, event, id_))
    messages = bus_.route(std::move(*message), *this);
  // A text that the routes ended is dealt with.
  const bool goes_on =
      std::any_of(messages.begin(), messages.end(), [](const Message& message) {
        return message.command == "Data";
      });
  if (event.kind == SocketEvent::Kind::text && !goes_on)
    sockets_.taken(id);
  return messages;
}

// -- frames -------------------------------------------------------------------

// A topic's actor is spawned when the session touches the topic first.
const topic_frame_actor& SessionPort::frame_of(script::TopicId topic) {
  auto& frame = frames_[topic];
  if (!frame)
    frame = self_->spawn(
        topic_frame, parts_->program, topic,
        trace_of(topic_frame_state::name, parts_->program->topics[topic].name));
  return frame;
}

void SessionPort::apply(script::TopicId topic,
                        std::shared_ptr<const dialogue::FrameRequest> request) {
  ask_frame_(frame_of(topic), std::move(request));
}

// -- another program ----------------------------------------------------------

void SessionPort::go_over(std::shared_ptr<const SessionParts> parts) {
  end_frames();
  parts_ = std::move(parts);
}

void SessionPort::begin_again(std::shared_ptr<const SessionParts> parts) {
  end_all();
  subscribe({});
  parts_ = std::move(parts);
}

// -- watching, ending ---------------------------------------------------------

void SessionPort::unhandled(const Message& message) {
  bus_.unhandled(message, "no state and no handler takes it", turn_);
}

bool SessionPort::inspected() const {
  return parts_->observer.watches_all();
}

// The last error is kept for who asks how the session is.
void SessionPort::inspect(Inspection inspection) {
  if (inspection.kind == InspectionKind::error)
    last_error_ = inspection.detail;
  inspection.turn = turn_;
  parts_->observer.inspect(std::move(inspection));
}

void SessionPort::conceal(const std::vector<std::string>& texts) {
  parts_->observer.discretion().conceal(id_, texts);
}

void SessionPort::conceal_turn() {
  parts_->observer.discretion().conceal_turn(id_);
}

void SessionPort::settled(std::uint64_t received) {
  parts_->observer.discretion().settled(id_, received);
}

void SessionPort::ended() {
  // The session looks at Conversation::ended() after each input.
}

std::vector<ActorHandle> SessionPort::children() const {
  std::vector<ActorHandle> all;
  auto add = [&all](const char* kind, std::string name, const auto& actor) {
    all.push_back(
        {kind, std::move(name), caf::actor_cast<caf::strong_actor_ptr>(actor)});
  };
  for (const auto& [id, timer] : timers_)
    add(timer_state::name, std::to_string(id), timer.actor);
  for (const auto& [id, query] : queries_)
    add(query_state::name, std::to_string(id), query.actor);
  for (const auto& [topic, frame] : frames_)
    add(topic_frame_state::name, parts_->program->topics[topic].name, frame);
  return all;
}

void SessionPort::close(std::vector<Message> unread) {
  perform([this, unread = std::move(unread)] {
    self_->send(parts_->manager, session_gone{id_, time_.work.begin(), unread});
    end_all();
  });
}

void SessionPort::pass_on(const std::vector<Message>& late) {
  perform([this, late] {
    self_->send(parts_->manager, forward{late, time_.work.begin()});
  });
}

SessionPort::~SessionPort() {
  end_all();
  parts_->observer.discretion().ended(id_);
}

// Safe to call twice: what was ended is forgotten.
void SessionPort::end_all() {
  alarm_.cancel_all();
  for (const auto& [id, timer] : std::exchange(timers_, {}))
    end_timer(timer);
  for (const auto& [id, query] : std::exchange(queries_, {})) {
    time_.due_times.remove(query.due);
    caf::anon_send_exit(query.actor, caf::exit_reason::user_shutdown);
  }
  sockets_.close_all();
  end_frames();
}

void SessionPort::end_frames() {
  for (const auto& [topic, frame] : std::exchange(frames_, {}))
    caf::anon_send_exit(frame, caf::exit_reason::user_shutdown);
}

} // namespace parlour::actors
