#include "actors/node/node.hpp"

#include <map>
#include <mutex>
#include <utility>

#include "actors/node/node_runtime.hpp"

namespace parlour::actors {

class Node::Implementation {
public:
  explicit Implementation(NodeOptions options) : runtime(std::move(options)) {}

  struct Seat {
    seat_actor actor;
    SessionId session; // empty: none
  };

  SessionId session_at(const SeatId& seat) {
    std::lock_guard lock(mutex);
    return seats[seat].session;
  }
  void set_session(const SeatId& seat, SessionId session) {
    std::lock_guard lock(mutex);
    seats[seat].session = std::move(session);
  }
  SessionId open(const SeatId& seat,
                 std::shared_ptr<const dialogue::SavedSession> saved);
  // Unless the next one is there already.
  void session_over(const SeatId& seat, const SessionId& session) {
    std::lock_guard lock(mutex);
    if (seats[seat].session == session)
      seats[seat].session.clear();
  }

  std::mutex mutex; // of the seats: session_over comes from their threads
  std::map<SeatId, Seat> seats;
  NodeRuntime runtime;
};

Node::Node(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

namespace {

// What cannot be destroyed, as threads of it still run; kept where it can be
// found, as it is no leak.
void leave_behind(std::shared_ptr<void> what) {
  static auto& mutex = *new std::mutex;
  static auto& all = *new std::vector<std::shared_ptr<void>>;
  std::lock_guard lock(mutex);
  all.push_back(std::move(what));
}

} // namespace

Node::~Node() {
  if (!stop())
    leave_behind(std::move(implementation_));
}

Expected<std::unique_ptr<Node>> Node::start(NodeOptions options) {
  auto implementation = std::make_unique<Implementation>(std::move(options));
  if (auto started = implementation->runtime.start_components(); !started) {
    if (!implementation->runtime.stop())
      leave_behind(std::move(implementation));
    return tl::make_unexpected(started.error());
  }
  return std::unique_ptr<Node>(new Node(std::move(implementation)));
}

// -- seats and sessions -------------------------------------------------------

SeatId Node::open_seat(SeatCallbacks callbacks) {
  auto& self = *implementation_;
  SeatCalls calls;
  SeatId id = "seat-" + std::to_string(self.seats.size() + 1);
  calls.on_say = std::move(callbacks.on_output);
  calls.on_over = [&self, id, tell = std::move(callbacks.on_session_end)](
                      const SessionId& session) {
    self.session_over(id, session);
    if (tell)
      tell(session);
  };
  calls.on_next = [&self, id](const SessionId& session) {
    self.set_session(id, session);
  };
  auto actor = self.runtime.open_seat(id, std::move(calls));
  std::lock_guard lock(self.mutex);
  self.seats[id].actor = std::move(actor);
  return id;
}

SessionId Node::open(const SeatId& seat) {
  return implementation_->open(seat, nullptr);
}

SessionId Node::go_on(const SeatId& seat, dialogue::SavedSession saved) {
  if (!session_at(seat).empty())
    return {};
  return implementation_->open(
      seat, std::make_shared<const dialogue::SavedSession>(std::move(saved)));
}

SessionId Node::Implementation::open(
    const SeatId& seat, std::shared_ptr<const dialogue::SavedSession> saved) {
  auto session = runtime.open_session(seats[seat].actor, std::move(saved));
  // It may be over already: a program without a beginning.
  if (runtime.sessions().find(session))
    set_session(seat, session);
  return session;
}

SessionId Node::session_at(const SeatId& seat) const {
  return implementation_->session_at(seat);
}

void Node::enter(const SeatId& seat, const std::vector<std::string>& lines) {
  auto session = session_at(seat);
  if (session.empty())
    session = open(seat);
  std::vector<Message> turns;
  for (const auto& line : lines) {
    Message turn;
    turn.source = "ASR";
    turn.command = "RecognitionResult";
    turn.params = {line, 1};
    turn.session = session;
    turns.push_back(std::move(turn));
  }
  implementation_->runtime.bus().bring_in(std::move(turns));
}

void Node::inject(const SessionId& session, Message message) {
  message.session = session;
  implementation_->runtime.bus().bring_in({std::move(message)});
}

Expected<void> Node::load(const std::string& plugin, const std::string& name) {
  return implementation_->runtime.load(plugin, name);
}

Expected<void> Node::unload(const std::string& name) {
  return implementation_->runtime.unload(name);
}

void Node::end(const SessionId& session) {
  if (!session.empty())
    implementation_->runtime.end_session(session);
}

bool Node::stop() {
  if (!implementation_->runtime.stop())
    return false;
  for (auto& [id, seat] : implementation_->seats)
    seat = {};
  return true;
}

// -- time ---------------------------------------------------------------------

bool Node::run_until_quiet() {
  return implementation_->runtime.scheduler().run_until_quiet();
}

bool Node::step_to_next_due(Milliseconds at_most) {
  return implementation_->runtime.scheduler().step_to_next_due(at_most);
}

std::optional<Timestamp> Node::next_timer() const {
  return implementation_->runtime.time().due_times.next_of_sessions();
}

void Node::advance(Milliseconds time) {
  implementation_->runtime.scheduler().advance(time);
}

void Node::interrupt() {
  implementation_->runtime.time().work.interrupt();
}

Timestamp Node::now() const {
  return implementation_->runtime.scheduler().clock().now();
}

// -- what can be seen ---------------------------------------------------------

Value Node::slot_value(const SessionId& session, const std::string& topic,
                       const std::string& slot) {
  return implementation_->runtime.slot_value(session, topic, slot);
}

std::string Node::state(const SessionId& session) {
  return implementation_->runtime.state_of(session);
}

std::string Node::masked(const std::string& text) const {
  return implementation_->runtime.observer().discretion().masked_afterwards(
      text);
}

bool Node::is_private(const std::string& words) const {
  return implementation_->runtime.observer().discretion().is_private(words);
}

std::vector<ActorStatus> Node::status(Milliseconds patience) {
  return implementation_->runtime.status(patience);
}

NodeCounters Node::counters() const {
  const auto& counters = implementation_->runtime.bus().counters();
  return {counters.messages(), counters.relayed, counters.filtered,
          counters.dropped, counters.unhandled};
}

} // namespace parlour::actors
