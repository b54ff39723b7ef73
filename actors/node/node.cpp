#include "actors/node/node.hpp"

#include <map>
#include <mutex>
#include <utility>

#include <caf/send.hpp>

#include "actors/node/house.hpp"
#include "script/dialogue/engine/conversation.hpp"

namespace parlour::actors {

class Node::Implementation {
public:
  explicit Implementation(NodeOptions options) : house(std::move(options)) {}

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
  // Unless the next one is there already.
  void session_over(const SeatId& seat, const SessionId& session) {
    std::lock_guard lock(mutex);
    if (seats[seat].session == session)
      seats[seat].session.clear();
  }
  void look_at(const SessionId& session,
               std::function<void(const dialogue::Conversation&)> at);

  std::mutex mutex; // of the seats: session_over comes from their threads
  std::map<SeatId, Seat> seats;
  House house;
};

void Node::Implementation::look_at(
    const SessionId& id,
    std::function<void(const dialogue::Conversation&)> at) {
  if (auto session = house.sessions().find(id)) {
    caf::anon_send(session, look{std::move(at), house.time().work.begin()});
    house.drive().run_until_quiet();
  }
}

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
  if (auto started = implementation->house.start_components(); !started) {
    if (!implementation->house.stop())
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
  auto actor = self.house.open_seat(id, std::move(calls));
  std::lock_guard lock(self.mutex);
  self.seats[id].actor = std::move(actor);
  return id;
}

SessionId Node::open(const SeatId& seat) {
  auto& self = *implementation_;
  auto session = self.house.open_session(self.seats[seat].actor);
  // It may be over already: a program without a beginning.
  if (self.house.sessions().find(session))
    self.set_session(seat, session);
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
  implementation_->house.bus().bring_in(std::move(turns));
}

void Node::inject(const SessionId& session, Message message) {
  message.session = session;
  implementation_->house.bus().bring_in({std::move(message)});
}

Expected<void> Node::load(const std::string& plugin, const std::string& name) {
  return implementation_->house.load(plugin, name);
}

Expected<void> Node::unload(const std::string& name) {
  return implementation_->house.unload(name);
}

void Node::end(const SessionId& session) {
  if (!session.empty())
    implementation_->house.end_session(session);
}

bool Node::stop() {
  if (!implementation_->house.stop())
    return false;
  for (auto& [id, seat] : implementation_->seats)
    seat = {};
  return true;
}

// -- time ---------------------------------------------------------------------

bool Node::run_until_quiet() {
  return implementation_->house.drive().run_until_quiet();
}

bool Node::step_to_next_due(Milliseconds at_most) {
  return implementation_->house.drive().step_to_next_due(at_most);
}

std::optional<Timestamp> Node::next_timer() const {
  return implementation_->house.time().due_times.next_of_sessions();
}

void Node::advance(Milliseconds time) {
  implementation_->house.drive().advance(time);
}

void Node::interrupt() {
  implementation_->house.time().work.interrupt();
}

Timestamp Node::now() const {
  return implementation_->house.drive().clock().now();
}

// -- what can be seen ---------------------------------------------------------

Value Node::slot_value(const SessionId& session, const std::string& topic,
                       const std::string& slot) {
  auto value = std::make_shared<Value>();
  implementation_->look_at(session, [=](const auto& conversation) {
    *value = conversation.slot_value(topic, slot);
  });
  return *value;
}

std::string Node::state(const SessionId& session) {
  auto state = std::make_shared<std::string>();
  implementation_->look_at(session, [=](const auto& conversation) {
    *state = conversation.state();
  });
  return *state;
}

std::string Node::masked(const std::string& text) const {
  const auto* discretion = implementation_->house.observer().discretion();
  return discretion ? discretion->masked_afterwards(text) : text;
}

bool Node::is_private(const std::string& words) const {
  const auto* discretion = implementation_->house.observer().discretion();
  return discretion && discretion->is_private(words);
}

NodeCounters Node::counters() const {
  const auto& counters = implementation_->house.bus().counters();
  return {counters.messages(), counters.relayed, counters.filtered,
          counters.dropped, counters.unhandled};
}

} // namespace parlour::actors
