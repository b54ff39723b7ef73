#include "actors/node/node.hpp"

#include <atomic>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "actors/node/node_runtime.hpp"
#include "runtime/message/typed_turn.hpp"

namespace parlour::actors {

class Node::Implementation {
public:
  explicit Implementation(NodeOptions options)
      : configured(options.program->settings.seats),
        runtime(std::move(options)) {
    for (const auto& seat : configured) {
      set_actor(seat.name, {}); // known before its actor
      set_actor(seat.name,
                runtime.open_seat(seat.name,
                                  calls_of(seat.name, calls_given(seat.name))));
    }
  }

  // A seat of a visit has no actor here: the session manager has it.
  struct Seat {
    seat_actor actor;
    SessionId session; // empty: none
    // Of a configured one, by open_seat(); null: not yet.
    std::shared_ptr<const SeatCallbacks> given = nullptr;
  };

  // What a tool has given for a configured seat, which exists before the tool
  // can ask for it.
  SeatCallbacks calls_given(const SeatId& seat) {
    const auto tell = [this, seat](auto callback, const auto&... what) {
      if (const auto given = seat_of(seat).given)
        if (const auto& call = (*given).*callback)
          call(what...);
    };
    return {[=](const auto& session, const auto& output) {
              tell(&SeatCallbacks::on_output, session, output);
            },
            [=](const auto& session) {
              tell(&SeatCallbacks::on_session_end, session);
            },
            [=](const auto& session) {
              tell(&SeatCallbacks::on_session_begin, session);
            },
            [=](const auto& session, auto turn) {
              tell(&SeatCallbacks::on_turns_done, session, turn);
            }};
  }
  // The first that nobody was given, who is given it now; empty: none is left.
  SeatId give_configured(SeatCallbacks& callbacks) {
    std::lock_guard lock(mutex);
    for (const auto& one : configured)
      if (auto& seat = seats[one.name]; !seat.given) {
        seat.given =
            std::make_shared<const SeatCallbacks>(std::move(callbacks));
        return one.name;
      }
    return {};
  }
  void set_actor(const SeatId& seat, seat_actor actor) {
    std::lock_guard lock(mutex);
    seats[seat].actor = std::move(actor);
  }

  // A seat that is closed has none.
  Seat seat_of(const SeatId& seat) {
    std::lock_guard lock(mutex);
    const auto found = seats.find(seat);
    return found == seats.end() ? Seat() : found->second;
  }
  void set_session(const SeatId& seat, SessionId session) {
    std::lock_guard lock(mutex);
    const auto found = seats.find(seat);
    if (found != seats.end())
      found->second.session = std::move(session);
  }
  // Known before its actor exists: the actor's first call may come at once.
  SeatId add_seat() {
    auto id = "seat-" + std::to_string(++last_seat);
    std::lock_guard lock(mutex);
    seats[id];
    return id;
  }
  // The seat's session is noted before the tool is told, so that the tool can
  // enter a line as soon as it hears of the session.
  SeatCalls calls_of(const SeatId& id, SeatCallbacks callbacks) {
    SeatCalls calls;
    calls.on_say = std::move(callbacks.on_output);
    calls.on_over = [this, id, tell = std::move(callbacks.on_session_end)](
                        const SessionId& session) {
      session_over(id, session);
      if (tell)
        tell(session);
    };
    calls.on_next = [this, id, tell = std::move(callbacks.on_session_begin)](
                        const SessionId& session) {
      set_session(id, session);
      if (tell)
        tell(session);
    };
    calls.on_turns_done = std::move(callbacks.on_turns_done);
    return calls;
  }
  // The last line has the turn's number: with it the whole turn has come.
  void bring_in(const SessionId& session, std::uint64_t number,
                const std::vector<std::string>& lines) {
    std::vector<Message> turns;
    for (const auto& line : lines) {
      const bool is_last = turns.size() + 1 == lines.size();
      turns.push_back(typed_turn(line, is_last ? number : 0));
      turns.back().session = session;
    }
    runtime.bus().bring_in(std::move(turns));
  }
  SessionId open(const SeatId& seat,
                 std::shared_ptr<const dialogue::SavedSession> saved);
  // Unless the next one is there already.
  // The seat may hear of the next session before it hears that the last is
  // over.
  void session_over(const SeatId& seat, const SessionId& session) {
    std::lock_guard lock(mutex);
    const auto found = seats.find(seat);
    if (found != seats.end() && found->second.session == session)
      found->second.session.clear();
  }

  std::mutex mutex; // of the seats: session_over comes from their threads
  std::unordered_map<SeatId, Seat> seats;
  std::atomic<std::uint64_t> last_seat = 0;
  const std::vector<SeatSettings> configured;
  // The last member: its actors, which call back into the others, end first.
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
  if (auto configured = self.give_configured(callbacks); !configured.empty())
    return configured;
  auto id = self.add_seat();
  self.set_actor(
      id, self.runtime.open_seat(id, self.calls_of(id, std::move(callbacks))));
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
  auto session = runtime.open_session(seat_of(seat).actor, std::move(saved));
  // It may be over already: a program without a beginning. In real time it may
  // end just now, but nobody finds it any more before the seat's calls, which
  // wait for the lock, tell so.
  std::lock_guard lock(mutex);
  if (const auto found = seats.find(seat);
      found != seats.end() && runtime.sessions().find(session))
    found->second.session = session;
  return session;
}

SessionId Node::session_at(const SeatId& seat) const {
  return implementation_->seat_of(seat).session;
}

// A line is the message ASR.RecognitionResult, as a recogniser would send it
// (runtime/message/typed_turn.hpp).
void Node::enter(const SeatId& seat, const std::vector<std::string>& lines) {
  auto session = session_at(seat);
  if (session.empty())
    session = open(seat);
  implementation_->bring_in(session, 0, lines);
}

SeatId Node::begin_visit(SeatCallbacks callbacks,
                         std::optional<dialogue::SavedSession> left) {
  auto& self = *implementation_;
  auto id = self.add_seat();
  self.runtime.begin_visit(
      id, self.calls_of(id, std::move(callbacks)),
      left ? std::make_shared<const dialogue::SavedSession>(*std::move(left))
           : nullptr);
  return id;
}

void Node::enter_turn(const SeatId& seat, std::uint64_t number,
                      const std::vector<std::string>& lines) {
  if (const auto session = session_at(seat); !session.empty())
    implementation_->bring_in(session, number, lines);
}

// Only the first call does anything: a visitor who goes and a session that ends
// may both lead here.
void Node::end_visit(const SeatId& seat) {
  auto& self = *implementation_;
  std::unique_lock lock(self.mutex);
  const bool was_there = self.seats.erase(seat) != 0;
  lock.unlock();
  if (was_there)
    self.runtime.end_visit(seat);
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

Expected<ReloadOutcome> Node::reload(ChangedApplication to, ReloadMode mode) {
  return implementation_->runtime.reloader().reload(std::move(to), mode);
}

void Node::end(const SessionId& session) {
  if (!session.empty())
    implementation_->runtime.end_session(session);
}

bool Node::stop() {
  if (!implementation_->runtime.stop())
    return false;
  std::lock_guard lock(implementation_->mutex);
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

// Also what was heard in private turns, unlike in the log: what a tool reports
// of a conversation is read by others.
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

Metrics Node::metrics(Milliseconds patience) {
  return implementation_->runtime.metrics(patience);
}

void Node::watch_all(bool wanted) {
  implementation_->runtime.observer().watch_all(wanted);
}

NodeCounters Node::counters() const {
  const auto& counters = implementation_->runtime.bus().counters();
  return {counters.messages(), counters.relayed, counters.filtered,
          counters.dropped, counters.unhandled};
}

} // namespace parlour::actors
