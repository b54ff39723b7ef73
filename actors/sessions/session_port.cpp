#include "actors/sessions/session_port.hpp"

#include <algorithm>
#include <utility>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/sessions/query.hpp"
#include "actors/sessions/session.hpp"
#include "actors/sessions/timer.hpp"
#include "actors/sessions/topic_frame.hpp"
#include "actors/support/thrown.hpp"

namespace parlour::actors {

namespace {

// Components that answer each other inline further than this go on by mailbox.
constexpr int inline_depth = 8;

} // namespace

SessionPort::SessionPort(Self self, std::shared_ptr<const SessionParts> parts,
                         SessionId id, seat_actor seat)
    : self_(self), parts_(std::move(parts)), time_(parts_->time),
      bus_(parts_->bus), id_(std::move(id)), seat_(std::move(seat)),
      sockets_(time_, parts_->sockets, session_actor(self_), id_) {}

// -- messages -----------------------------------------------------------------

std::vector<Message> SessionPort::post(Message message) {
  std::vector<Message> back;
  if (message.session.empty())
    message.session = id_;
  if (message.session != id_) {
    bus_.publish({std::move(message)});
    return back;
  }
  carry(std::move(message), back);
  return back;
}

void SessionPort::carry(Message message, std::vector<Message>& back, int depth,
                        Answers answers) {
  auto table = bus_.table();
  auto routed = table->route(std::move(message));
  bus_.unreached(routed);
  for (auto& [target, sent] : routed.deliveries)
    if (target->direct && depth < inline_depth)
      for (auto& event : ask_directly(*target, *sent))
        carry(std::move(event), back, depth + 1, answers);
    else if (auto answer =
                 bus_.hand_over(*target, {std::move(sent), time_.work.begin()});
             answer && answers == Answers::yes)
      carry(std::move(*answer), back, depth + 1, Answers::no);
  if (routed.rest)
    back.push_back(std::move(*routed.rest));
}

// A component without state, in the session's own turn.
std::vector<Message> SessionPort::ask_directly(const Target& target,
                                               const Message& message) {
  std::vector<Answer> answers;
  if (auto reason =
          thrown_by([&] { answers = target.direct->answers(message); })) {
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
  self_->send(seat_, say{id_, std::make_shared<const dialogue::Output>(output),
                         time_.work.begin()});
}

// -- timers, queries ----------------------------------------------------------

Timestamp SessionPort::due_at(Milliseconds after) const {
  return time_.now() + after.count();
}

void SessionPort::start_timer(dialogue::TimerId id, Milliseconds after) {
  cancel_timer(id);
  auto due = time_.due_times.add(due_at(after), DueTimes::Of::session);
  auto actor = self_->spawn(timer, &time_, session_actor(self_),
                            TimerOrder{id, after, due});
  timers_.emplace(id, Timer{std::move(actor), due});
}

void SessionPort::cancel_timer(dialogue::TimerId id) {
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

void SessionPort::component(dialogue::ComponentRequest request) {
  auto work = time_.work.begin();
  auto done = [session = session_actor(self_), id = request.id,
               &work_count = time_.work](Expected<void> outcome) {
    caf::anon_send(
        session, component_outcome{id, std::move(outcome), work_count.begin()});
  };
  if (request.load)
    self_->send(parts_->supervisor,
                load_plugin{std::move(request.plugin), std::move(request.name),
                            std::move(done), std::move(work)});
  else
    self_->send(parts_->supervisor,
                unload_component{std::move(request.name), std::move(done),
                                 std::move(work)});
}

void SessionPort::file(dialogue::QueryId id, FileRequest request) {
  self_->send(parts_->file_keeper,
              file_order{id, std::move(request), session_actor(self_),
                         time_.work.begin()});
}

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

std::vector<Message> SessionPort::hear_socket(dialogue::SocketId id,
                                              const SocketEvent& event) {
  std::vector<Message> messages;
  if (auto message = sockets_.message(id, event))
    carry(std::move(*message), messages);
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

const topic_frame_actor& SessionPort::frame_of(script::TopicId topic) {
  auto& frame = frames_[topic];
  if (!frame)
    frame = self_->spawn(topic_frame, parts_->program, topic);
  return frame;
}

void SessionPort::apply(script::TopicId topic, dialogue::FrameRequest request) {
  ask_frame(self_, frame_of(topic),
            std::make_shared<const dialogue::FrameRequest>(std::move(request)));
}

// -- watching, ending ---------------------------------------------------------

void SessionPort::unhandled(const Message& message) {
  bus_.unhandled(message, "no state and no handler takes it");
}

bool SessionPort::inspected() const {
  return parts_->observer.watches_all();
}

void SessionPort::inspect(Inspection inspection) {
  parts_->observer.inspect(std::move(inspection));
}

void SessionPort::conceal(const std::vector<std::string>& texts) {
  if (auto* discretion = parts_->observer.discretion())
    discretion->conceal(id_, texts);
}

void SessionPort::conceal_turn() {
  if (auto* discretion = parts_->observer.discretion())
    discretion->conceal_turn(id_);
}

void SessionPort::settled(std::uint64_t received) {
  if (auto* discretion = parts_->observer.discretion())
    discretion->settled(id_, received);
}

void SessionPort::ended() {
  // The session looks at Conversation::ended() after each input.
}

void SessionPort::close(std::vector<Message> unread) {
  self_->send(parts_->manager,
              session_gone{id_, time_.work.begin(), std::move(unread)});
  end_all();
}

SessionPort::~SessionPort() {
  end_all();
  if (auto* discretion = parts_->observer.discretion())
    discretion->ended(id_);
}

void SessionPort::end_all() {
  for (const auto& [id, timer] : std::exchange(timers_, {}))
    end_timer(timer);
  for (const auto& [id, query] : std::exchange(queries_, {})) {
    time_.due_times.remove(query.due);
    caf::anon_send_exit(query.actor, caf::exit_reason::user_shutdown);
  }
  sockets_.close_all();
  for (const auto& [topic, frame] : std::exchange(frames_, {}))
    caf::anon_send_exit(frame, caf::exit_reason::user_shutdown);
}

} // namespace parlour::actors
