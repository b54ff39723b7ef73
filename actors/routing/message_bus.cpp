#include "actors/routing/message_bus.hpp"

#include <utility>

#include <caf/send.hpp>

namespace parlour::actors {

namespace {

// As ComponentMailbox::put says.
const char* put(const Target& target, ComponentMailbox::Job& job) {
  if (!target.by_session)
    return target.mailbox->put(job);
  const auto mailbox = target.mailbox_of(job.message->session);
  return mailbox ? mailbox->put(job) : "has no instance for that session";
}

} // namespace

Message failure_answer(const std::string& component, const Message& message,
                       const std::string& reason) {
  Message event;
  event.source = component;
  event.command = "Failed";
  event.params = {reason};
  event.session = message.session;
  event.correlation = message.correlation;
  event.rounds = message.rounds + 1;
  return event;
}

// A message without a correlation was posted by somebody who does not wait.
std::optional<Message> answer_for_failed(const std::string& component,
                                         const Message& message,
                                         const std::string& reason) {
  if (message.correlation == 0)
    return std::nullopt;
  return failure_answer(component, message, reason);
}

// -- the node -----------------------------------------------------------------

MessageBus::MessageBus(NodeTime& time, Observer& observer,
                       std::shared_ptr<const script::Program> program,
                       Aliases aliases)
    : time_(time), observer_(observer),
      parts_(parts(std::move(program), std::move(aliases))) {
  store({});
}

RoutingTable::Parts
MessageBus::parts(std::shared_ptr<const script::Program> program,
                  Aliases aliases) {
  RoutingTable::Parts parts;
  parts.program = std::move(program);
  parts.aliases = std::move(aliases);
  parts.clock = &time_.clock;
  parts.counters = std::make_shared<Counters>();
  parts.complain = [this](const Message& message, const Error& error) {
    failed(message, error);
  };
  parts.is_tapped = &observer_.follows_messages();
  if (observer_.may_follow())
    parts.taps.emplace_back(
        [this](const Message& message, const std::string& way) {
          observer_.follow(message, way);
        });
  return parts;
}

void MessageBus::connect(message_centre_actor centre) {
  centre_.store(
      std::make_shared<const message_centre_actor>(std::move(centre)));
}

// The lock keeps a supervisor that still publishes a table from bringing the
// targets back.
void MessageBus::take_down() {
  const std::lock_guard lock(storing_);
  down_ = true;
  store({});
  centre_.store(nullptr);
}

// -- the table ----------------------------------------------------------------

void MessageBus::set_targets(std::vector<Target> targets) {
  const std::lock_guard lock(storing_);
  if (!down_)
    store(std::move(targets));
}

// Targets stay: whom a route leads to is found by name in each table.
void MessageBus::set_program(std::shared_ptr<const script::Program> program) {
  const std::lock_guard lock(storing_);
  parts_.program = std::move(program);
  if (!down_)
    store(table()->targets());
}

void MessageBus::store(std::vector<Target> targets) {
  auto parts = parts_;
  parts.targets = std::move(targets);
  table_.store(std::make_shared<const RoutingTable>(std::move(parts)));
}

bool MessageBus::is_heard(const Message& message) const {
  return !message.params.empty() && table()->is_source("ASR", message.source);
}

// -- messages -----------------------------------------------------------------

// In virtual time another thread than the node's must wait for its turn: the
// message is queued, and its token is one of its own.
void MessageBus::publish(Message&& message, Timestamp now, InFlight held) {
  if (time_.main_thread.defers())
    return publish(std::vector{std::move(message)});
  std::vector<Message> for_sessions;
  Way way{now, for_sessions, nullptr, std::move(held)};
  carry(std::move(message), way);
  pass_to_centre(std::move(for_sessions));
}

void MessageBus::publish(std::vector<Message> messages) {
  time_.main_thread.post([this, messages = std::move(messages),
                          waits = time_.work.begin()]() mutable {
    pass_to_centre(route(std::move(messages)));
  });
}

// Not routed here: who watches the node may call this from a tap, and the
// centre's mailbox keeps the order.
void MessageBus::bring_in(std::vector<Message> messages) {
  time_.main_thread.post([this, messages = std::move(messages),
                          waits = time_.work.begin(),
                          now = NodeMetrics::now()]() mutable {
    if (const auto centre = centre_.load())
      caf::anon_send(*centre,
                     actors::publish{{std::move(messages), waits, now}});
  });
}

std::vector<Message> MessageBus::route(std::vector<Message> messages) {
  std::vector<Message> for_sessions;
  Way way{0, for_sessions};
  for (auto& message : messages) {
    way.now = time_.now();
    carry(std::move(message), way);
  }
  return for_sessions;
}

// What comes back is for the caller's own session, or for others: the caller
// sorts it out.
std::vector<Message> MessageBus::route(Message message, InlineCaller& caller) {
  std::vector<Message> for_sessions;
  Way way{time_.now(), for_sessions, &caller};
  carry(std::move(message), way);
  return for_sessions;
}

// What nobody fills is told before anything is delivered: the trace shows the
// reason ahead of what the message led to.
void MessageBus::carry(Message&& message, Way& way, int depth,
                       Answers answers) {
  if (down_)
    return;
  const auto current = table(); // the deliveries point into it
  auto routed = current->route(std::move(message), way.now);
  unreached(routed);
  for (auto& delivery : routed.deliveries)
    deliver(delivery, way, depth, answers);
  if (routed.deliveries.empty() && answers == Answers::yes)
    answer_for_nobody(routed.unreached, way, depth);
  if (routed.for_session)
    way.for_sessions.push_back(std::move(*routed.for_session));
}

// Whoever asks has made sure that somebody is there; but he may have gone
// since.
void MessageBus::answer_for_nobody(const std::vector<Unreached>& unreached,
                                   Way& way, int depth) {
  if (unreached.empty())
    return;
  const auto& [sink, message] = unreached.front();
  if (auto answer = answer_for_failed(sink, *message, "nobody is there for it"))
    carry(std::move(*answer), way, depth + 1, Answers::no);
}

// Each message is answered once: by its component, or for it.
//
// In this order: an inline component answers here and now; a strict session may
// keep the message back; else it goes into the mailbox, with the sender's own
// token if that is still there.
void MessageBus::deliver(Delivery& delivery, Way& way, int depth,
                         Answers answers) {
  auto& [target, sent] = delivery;
  if (way.caller && target->direct && depth < inline_depth) {
    for (auto& event : way.caller->call(*target, *sent))
      carry(std::move(event), way, depth + 1, answers);
    return;
  }
  if (way.caller && way.caller->keep_back(*target, sent))
    return;
  if (!way.held)
    way.held = time_.work.begin();
  auto answer = hand_over(*target, {std::move(sent), std::move(way.held)});
  if (answer && answers == Answers::yes)
    carry(std::move(*answer), way, depth + 1, Answers::no);
}

// Sessions get their messages by one actor, so that all senders' messages have
// one order.
void MessageBus::pass_to_centre(std::vector<Message> messages) {
  if (messages.empty())
    return;
  if (const auto centre = centre_.load())
    caf::anon_send(*centre,
                   distribute{std::move(messages), time_.work.begin()});
}

std::optional<Message> MessageBus::hand_over(const Target& target,
                                             ComponentMailbox::Job job) {
  const auto* why = put(target, job);
  if (!why)
    return std::nullopt;
  const auto reason = target.name + " " + why;
  unhandled(*job.message, reason);
  return answer_for_failed(target.name, *job.message, reason);
}

// Without a centre nothing else can be on its way to the session.
void MessageBus::ring(const session_actor& session, timer_due what) {
  if (const auto centre = centre_.load())
    caf::anon_send(*centre, actors::ring{session, std::move(what)});
  else
    caf::anon_send(session, std::move(what));
}

void MessageBus::retire(session_actor session, InFlight work) {
  if (const auto centre = centre_.load())
    caf::anon_send(*centre,
                   actors::retire{std::move(session), std::move(work)});
}

// A refusal needs no answer here: the caller fails at once where nobody took
// it.
bool MessageBus::ask(Message question, const InFlight& work) {
  const auto current = table(); // the deliveries point into it
  auto routed = current->route(std::move(question));
  bool taken = false;
  for (auto& [target, sent] : routed.deliveries)
    taken |= !hand_over(*target, {std::move(sent), work});
  return taken;
}

// -- what goes wrong ----------------------------------------------------------

// Routine events, such as how far a voice has come, are for whoever is
// interested: that nobody was is no news (engine rule 1.4).
void MessageBus::unhandled(const Message& message, const std::string& why,
                           std::uint64_t turn) {
  if (table()->is_routine(message))
    return;
  ++parts_.counters->unhandled;
  Inspection inspection;
  inspection.kind = InspectionKind::unhandled;
  inspection.session = message.session;
  inspection.subject = message.source + "." + message.command;
  inspection.detail = why;
  inspection.message = std::make_shared<const Message>(message);
  inspection.turn = turn;
  observer_.inspect(std::move(inspection));
}

void MessageBus::unreached(const Routed& routed) {
  for (const auto& [sink, message] : routed.unreached)
    unhandled(*message, "nobody is there for " + sink);
}

void MessageBus::failed(const Message& message, const Error& error) {
  Inspection inspection;
  inspection.kind = InspectionKind::error;
  inspection.session = message.session;
  inspection.subject = name_of(error.kind);
  inspection.detail = to_string(error);
  observer_.inspect(std::move(inspection));
}

} // namespace parlour::actors
