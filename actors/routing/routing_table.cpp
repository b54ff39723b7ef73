#include "actors/routing/routing_table.hpp"

#include <algorithm>
#include <utility>

#include "actors/routing/route_host.hpp"
#include "runtime/message/replies.hpp"
#include "runtime/message/roles.hpp"

namespace parlour::actors {

namespace {

// By event and source alone: whether a reaction's own condition holds, only its
// session can say.
bool any_of(const std::vector<script::Reaction>& reactions,
            const RoutingTable& table, const Message& message) {
  return std::any_of(
      reactions.begin(), reactions.end(), [&](const auto& reaction) {
        return (reaction.event == "*" || reaction.event == message.command) &&
               table.is_source(reaction.source, message.source);
      });
}

} // namespace

bool Target::is_up(const SessionId& session) const {
  if (!by_session)
    return *up;
  const auto instance = by_session->find(session);
  return instance && *instance->up;
}

std::shared_ptr<ComponentMailbox>
Target::mailbox_of(const SessionId& session) const {
  if (!by_session)
    return mailbox;
  const auto instance = by_session->find(session);
  return instance ? instance->mailbox : nullptr;
}

RoutingTable::RoutingTable(Parts parts)
    : parts_(std::move(parts)),
      conditions_(
          std::make_shared<const script::InterpreterPool>(parts_.program)) {}

// -- names --------------------------------------------------------------------

// The role that an alias stands for; any other name stays as it is.
std::string_view RoutingTable::role(std::string_view name) const {
  auto found = parts_.aliases.find(name);
  return found == parts_.aliases.end() ? name : std::string_view(found->second);
}

const Target* RoutingTable::named(std::string_view name) const {
  for (const auto& target : parts_.targets)
    if (target.name == name)
      return &target;
  return nullptr;
}

template <class Take>
void RoutingTable::for_targets_of(std::string_view sink,
                                  const SessionId& session, Take&& take) const {
  if (auto target = named(sink)) {
    if (target->is_up(session))
      take(*target);
    return;
  }
  // The name of a component means that one: if it is down, its role's next does
  // not take its place. A role means the first that is up, "ASR*" each.
  const bool all = sink.ends_with('*');
  const auto wanted = role(sink.substr(0, sink.size() - all));
  for (const auto& target : parts_.targets)
    if (std::count(target.roles.begin(), target.roles.end(), wanted) &&
        target.is_up(session)) {
      take(target);
      if (!all)
        return;
    }
}

// For "Role*" as well: whoever asks wants to know whether somebody is there.
const Target* RoutingTable::find(std::string_view module,
                                 const SessionId& session) const {
  const Target* first = nullptr;
  for_targets_of(module, session, [&](const Target& target) {
    if (!first)
      first = &target;
  });
  return first;
}

// A script that listens to "NLU" hears GrammarNLU, one that listens to "Record"
// hears the microphone. A source without a target (ASR, for a typed line) is a
// role itself.
bool RoutingTable::is_source(std::string_view module,
                             std::string_view source) const {
  if (module == "*" || module == source || role(module) == role(source))
    return true;
  auto target = named(source);
  return target &&
         std::count(target->roles.begin(), target->roles.end(), role(module));
}

// An event that nobody has described counts as an answer.
// So a component's own event, which no role describes, ends a request too
// (engine rule 1.3).
Reply RoutingTable::reply_to_request(const Message& event) const {
  const auto* target = named(event.source);
  const auto known =
      target ? find_reply(event.command, target->roles, target->events)
             : find_reply(event.command, {std::string(role(event.source))});
  return known.value_or(Reply::answer);
}

bool RoutingTable::begins_turn(const Message& message) const {
  return message.command == "RecognitionResult" &&
         is_source("ASR", message.source);
}

// A message with sinks is a command: that nobody took it is never routine.
bool RoutingTable::is_routine(const Message& message) const {
  const auto says_so = [&](std::string_view role_name) {
    const auto* its = find_role(role_name);
    const auto* event = its ? its->event(message.command) : nullptr;
    return event && event->routine;
  };
  if (!message.sinks.empty())
    return false;
  const auto* target = named(message.source);
  return target ? std::ranges::any_of(target->roles, says_so)
                : says_so(role(message.source));
}

// Of all states, not of the active one: the sender does not know in which state
// a session is. <Online> and <Offline> are reactions to two events of System
// (engine rule 4.5).
bool RoutingTable::is_listened_to(const Message& message) const {
  const auto& program = *parts_.program;
  for (const auto& handler : program.handlers)
    if (any_of(handler.reactions, *this, message))
      return true;
  const bool tells_of_agent =
      message.source == "System" &&
      (message.command == "AgentOnline" || message.command == "AgentOffline");
  for (const auto& state : program.states)
    if (any_of(state.messages, *this, message) ||
        (tells_of_agent && (!state.online.empty() || !state.offline.empty())))
      return true;
  return false;
}

bool RoutingTable::opens(const Message& message, std::string_view seat) const {
  return std::ranges::any_of(
      parts_.program->openings, [&](const script::Opening& opening) {
        return (opening.seat.empty() || opening.seat == seat) &&
               matches(opening, message);
      });
}

bool RoutingTable::has_instances_by_session() const {
  return std::any_of(
      parts_.targets.begin(), parts_.targets.end(),
      [](const Target& target) { return target.by_session != nullptr; });
}

// -- a message's way (engine rule 1) ------------------------------------------

Routed RoutingTable::route(Message message) const {
  return route(std::move(message), parts_.clock->now());
}

// The routes come before the sinks: a filter may turn away what names its
// receiver.
Routed RoutingTable::route(Message&& message, Timestamp now) const {
  Routed routed;
  stamp(message, now);
  if (goes_in_a_ring(message) || apply_routes(message, routed))
    return routed;
  if (message.sinks.empty()) {
    pass_on_values(message, routed);
    ++parts_.counters->to_sessions;
    if (is_tapped())
      tap(message, message.session.empty() ? "every session" : "session");
    routed.for_session = std::move(message);
    return routed;
  }
  const auto shared = std::make_shared<const Message>(std::move(message));
  for (const auto& sink : shared->sinks) {
    if (is_tapped())
      tap(*shared, "-> " + sink);
    deliver(shared, sink, routed);
  }
  return routed;
}

// Numbers are unique in a node; the order of two threads' messages is theirs.
void RoutingTable::stamp(Message& message, Timestamp now) const {
  message.time = now;
  message.number = ++parts_.counters->numbers;
}

// Dropped then, and told once in a second.
bool RoutingTable::goes_in_a_ring(const Message& message) const {
  const auto verdict = parts_.counters->rounds.judge(message);
  if (verdict == RoundLimit::Verdict::passes)
    return false;
  ++parts_.counters->circled;
  if (is_tapped())
    tap(message, "dropped");
  if (verdict == RoundLimit::Verdict::first_too_many && parts_.complain)
    parts_.complain(message,
                    {ErrorKind::limit,
                     message.source + "." + message.command +
                         " goes in a ring: components, relays or handlers "
                         "answer each other more than " +
                         std::to_string(RoundLimit::each_second) +
                         " times in a second; the rest is dropped",
                     {}});
  return true;
}

// True where a filter ended the message's way.
bool RoutingTable::apply_routes(const Message& message, Routed& routed) const {
  for (const auto& route : parts_.program->routes) {
    if (!matches(route, message))
      continue;
    auto& counter = route.drop        ? parts_.counters->dropped
                    : route.is_filter ? parts_.counters->filtered
                                      : parts_.counters->relayed;
    ++counter;
    if (!route.drop)
      send_copies(route, message, routed);
    else if (is_tapped())
      tap(message, "dropped");
    if (route.is_filter)
      return true;
  }
  return false;
}

// The cheap tests come first: a condition is a script that has to run.
template <class Rule>
bool RoutingTable::matches(const Rule& rule, const Message& message) const {
  return (rule.command == "*" || rule.command == message.command) &&
         is_source(rule.source, message.source) &&
         holds(rule.condition, message);
}

bool RoutingTable::holds(script::CodeId condition,
                         const Message& message) const {
  return condition == script::no_code || bool(evaluate(condition, message));
}

// Conditions see the message's own fields and constants, nothing of a session.
Value RoutingTable::evaluate(script::CodeId code,
                             const Message& message) const {
  RouteHost host(message, message.time);
  script::ActivationContext context;
  context.message = std::make_shared<const Message>(message);
  auto value = conditions_->evaluate(code, {}, std::move(context), host);
  if (value)
    return std::move(*value);
  ++parts_.counters->failed_conditions;
  if (parts_.complain)
    parts_.complain(message, value.error());
  return {};
}

// Whoever understands or hears the values of a column is told of new ones
// (engine rule 1.9): all components of these roles, in all seats.
void RoutingTable::pass_on_values(const Message& message,
                                  Routed& routed) const {
  if (message.command != "ValuesChanged" ||
      !is_source("Database", message.source))
    return;
  auto copy = message;
  copy.command = "SetValues";
  ++copy.rounds;
  // Each copy has a number and a session of its own: an instance of a session
  // finds its mailbox by that.
  const auto give = [&](const Target& target, SessionId session) {
    copy.number = ++parts_.counters->numbers;
    ++parts_.counters->copies;
    copy.session = std::move(session);
    copy.sinks = {target.name};
    if (is_tapped())
      tap(copy, "relay -> " + target.name);
    routed.deliveries.push_back(
        {&target, std::make_shared<const Message>(copy)});
  };
  for (const auto& target : parts_.targets) {
    if (!std::ranges::count(target.roles, "NLU") &&
        !std::ranges::count(target.roles, "ASR"))
      continue;
    if (target.by_session)
      for (auto& session : target.by_session->sessions())
        give(target, std::move(session));
    else if (target.is_up({}))
      give(target, {});
  }
}

// A copy is routed no further: relays lead straight to components.
void RoutingTable::send_copies(const script::Route& route,
                               const Message& message, Routed& routed) const {
  for (const auto& to : route.to) {
    const auto copy =
        std::make_shared<const Message>(copy_for(route, message, to));
    if (is_tapped())
      tap(*copy, (route.is_filter ? "filter -> " : "relay -> ") + to);
    deliver(copy, to, routed);
  }
}

// A copy is one round further from what came from outside (round_limit.hpp).
Message RoutingTable::copy_for(const script::Route& route,
                               const Message& message,
                               const std::string& to) const {
  auto copy = message;
  copy.number = ++parts_.counters->numbers;
  ++parts_.counters->copies;
  ++copy.rounds;
  copy.sinks = {to};
  if (!route.as.empty())
    copy.command = route.as;
  if (route.has_params) {
    copy.params.clear();
    for (auto code : route.params)
      copy.params.push_back(evaluate(code, message));
  }
  return copy;
}

// One message object is shared by all who get it.
void RoutingTable::deliver(const SharedMessage& message, const std::string& to,
                           Routed& routed) const {
  bool nobody = true;
  for_targets_of(to, message->session, [&](const Target& target) {
    routed.deliveries.push_back({&target, message});
    nobody = false;
  });
  if (nobody)
    routed.unreached.push_back({to, message});
}

// Asked before a way is put in words.
bool RoutingTable::is_tapped() const {
  return !parts_.taps.empty() &&
         (!parts_.is_tapped ||
          parts_.is_tapped->load(std::memory_order_relaxed));
}

void RoutingTable::tap(const Message& message, const std::string& way) const {
  for (const auto& tap : parts_.taps)
    tap(message, way);
}

} // namespace parlour::actors
