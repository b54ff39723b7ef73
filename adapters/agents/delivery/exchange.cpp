#include "adapters/agents/delivery/exchange.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::agents {
namespace {

WireError identity(std::string sentence) {
  return {WireErrorKind::identity, std::move(sentence)};
}

// Takes the same time wherever the texts differ: otherwise the time would tell
// an attacker how many letters of a guessed token are right.
bool same_secret(std::string_view left, std::string_view right) {
  if (left.size() != right.size())
    return false;
  int difference = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    difference |= left[i] ^ right[i];
  return difference == 0;
}

// Each transport asks for its own credential only
// (adapters/agents/PROTOCOL.md 2.4).
Read<void> check_credential(const AgentAccount& account, const Peer& peer,
                            const Hello& hello) {
  const std::string what = peer.key ? "key" : "token";
  const auto& wanted = peer.key ? account.public_key : account.token;
  const auto& given = peer.key ? *peer.key : hello.token;
  if (wanted.empty() && peer.is_remote)
    return tl::make_unexpected(
        identity("off loopback an agent needs a " + what +
                 ", and the settings give this one none"));
  if (!wanted.empty() && !same_secret(wanted, given))
    return tl::make_unexpected(identity("the " + what + " is not the agent's"));
  return {};
}

} // namespace

AgentExchange::AgentExchange(std::vector<AgentAccount> accounts,
                             std::string incarnation, Connections& connections,
                             Platform& platform)
    : connections_(connections), platform_(platform) {
  for (auto& account : accounts) {
    const auto name = account.name;
    agents_.emplace(name, Agent{std::move(account), Link(incarnation, window)});
  }
}

// -- connections --------------------------------------------------------------

// Beyond the limit a connection is accepted only to be told so: `flood` closes
// it.
void AgentExchange::opened(ConnectionId id, Peer peer, Timestamp now) {
  now_ = now;
  open_[id] = {std::move(peer), now};
  if (open_.size() > max_connections)
    tell(id, {WireErrorKind::flood, "too many connections are open"});
}

void AgentExchange::heard(ConnectionId id, Timestamp now) {
  now_ = now;
  const auto found = open_.find(id);
  if (found != open_.end() && found->second.agent)
    found->second.agent->link.heard(now);
}

void AgentExchange::closed(ConnectionId id) {
  const auto found = open_.find(id);
  if (found == open_.end())
    return;
  auto* agent = found->second.agent;
  open_.erase(found);
  if (agent && agent->connection == id)
    lose_connection(*agent);
}

void AgentExchange::drop(ConnectionId id) {
  connections_.close(id);
  closed(id);
}

// Whoever is disconnected by intent is not waited for.
void AgentExchange::end(ConnectionId id) {
  auto* agent = open_.at(id).agent;
  drop(id);
  if (agent && agent->connection == 0)
    go_offline(*agent);
}

// An agent that connects again soon goes on where it was, and nobody notices.
void AgentExchange::lose_connection(Agent& agent) {
  agent.connection = 0;
  agent.left = now_;
  agent.link.disconnect();
  if (!agent.link.may_return())
    go_offline(agent);
}

// Requests end now (adapters/agents/PROTOCOL.md 4.7). Other messages that wait
// for the agent stay in its link.
void AgentExchange::go_offline(Agent& agent) {
  if (!std::exchange(agent.is_online, false))
    return;
  agent.link.withdraw_requests();
  platform_.offline(agent.account.name);
}

void AgentExchange::tell(ConnectionId id, const WireError& error,
                         std::optional<std::uint64_t> answered) {
  platform_.mistake(open_.at(id).peer.name, error);
  auto message = error_message(error);
  message.correlation = answered;
  connections_.write(id, message);
  if (error.kind == WireErrorKind::replaced)
    drop(id); // it is connected all the same
  else if (closes_connection(error))
    end(id);
}

void AgentExchange::tell_counted(ConnectionId id, WireError error,
                                 std::optional<std::uint64_t> answered) {
  if (++open_.at(id).malformed >= max_malformed && !closes_connection(error))
    error = {WireErrorKind::flood,
             "too many mistakes in a row; the last: " + error.sentence};
  tell(id, error, answered);
}

// -- what arrives -------------------------------------------------------------

void AgentExchange::arrived(ConnectionId id, Read<AgentMessage>&& message,
                            Timestamp now) {
  const auto found = open_.find(id);
  if (found == open_.end())
    // It was closed before this message was read.
    return;
  now_ = now;
  auto& connection = found->second;
  if (!message)
    tell_counted(id, std::move(message.error()));
  else if (message->kind == MessageKind::hello)
    greet(id, *message, now);
  else if (message->kind == MessageKind::bye)
    say_bye(id, connection, *message, now);
  else if (connection.agent)
    take(id, connection, std::move(*message), now);
  else
    tell_counted(id, {WireErrorKind::unknown, "say hello first"});
}

// What a bye acknowledges is not sent again.
void AgentExchange::say_bye(ConnectionId id, Connection& connection,
                            const AgentMessage& message, Timestamp now) {
  if (connection.agent)
    connection.agent->link.receive(message, now);
  end(id);
}

// Checks that the agent is the one whose name it gives
// (adapters/agents/PROTOCOL.md 3.3 and 3.4).
Read<Hello> AgentExchange::admit(const Connection& connection,
                                 const AgentMessage& message) {
  auto hello = hello_of(message);
  if (!hello)
    return hello;
  if (auto version = common_version(*hello); !version)
    return tl::make_unexpected(std::move(version.error()));
  const auto found = agents_.find(hello->name);
  if (found == agents_.end())
    return tl::make_unexpected(
        identity("no agent is called '" + excerpt(hello->name) + "'"));
  if (auto checked =
          check_credential(found->second.account, connection.peer, *hello);
      !checked)
    return tl::make_unexpected(std::move(checked.error()));
  if (connection.agent && connection.agent != &found->second)
    return tl::make_unexpected(
        identity("this connection belongs to another agent"));
  if (auto checked = check_rate(found->second); !checked)
    return tl::make_unexpected(std::move(checked.error()));
  return hello;
}

Read<void> AgentExchange::check_rate(Agent& agent) {
  if (now_ - agent.hellos_since >= 1000) {
    agent.hellos_since = now_;
    agent.hellos = 0;
  }
  if (++agent.hellos > max_hellos_per_second)
    return tl::make_unexpected(
        WireError{WireErrorKind::flood,
                  "the agent says hello more often than a second allows"});
  return {};
}

void AgentExchange::greet(ConnectionId id, const AgentMessage& message,
                          Timestamp now) {
  auto& connection = open_.at(id);
  const auto hello = admit(connection, message);
  if (!hello) {
    tell(id, hello.error());
    // Whatever the error is.
    if (open_.contains(id))
      end(id);
    return;
  }
  auto& agent = agents_.find(hello->name)->second;
  // An agent has one connection: the former one may be dead without having been
  // noticed.
  if (agent.connection != 0 && agent.connection != id)
    tell(agent.connection,
         {WireErrorKind::replaced, "the agent has connected anew"});
  connection.agent = &agent;
  connection.peer.name = hello->name;
  connection.malformed = 0;
  agent.connection = id;
  agent.json = hello->json;
  welcome(id, agent, *hello, now);
}

// An agent with which the platform begins afresh must not believe that it goes
// on (adapters/agents/PROTOCOL.md 3.2).
void AgentExchange::welcome(ConnectionId id, Agent& agent, const Hello& hello,
                            Timestamp now) {
  auto& link = agent.link;
  if (!link.goes_on_with(hello.introduction)) {
    go_offline(agent); // its process has ended, or has forgotten all
    if (agent.is_known)
      link.renew(new_incarnation());
  }
  agent.is_known = agent.is_online = true;
  link.connect(hello.introduction, now);
  auto own = link.introduction();
  own.packed = hello.introduction.packed;
  connections_.write(id, welcome_message(own, *common_version(hello)));
  if (own.packed)
    connections_.pack(id);
  platform_.online(hello);
  flush(agent, now);
}

// A message of an agent that is online. The link decides whether it is new.
void AgentExchange::take(ConnectionId id, Connection& connection,
                         AgentMessage&& message, Timestamp now) {
  auto& agent = *connection.agent;
  auto arrival = agent.link.receive(message, now);
  if (arrival.error) {
    tell_counted(id, std::move(*arrival.error));
    return;
  }
  if (arrival.deliver) {
    const bool numbered = message.number.has_value();
    // This may end the connection.
    hand_on(id, agent, std::move(message));
    // A message that is refused counts as handed on too: it must not be sent
    // again.
    if (numbered)
      agent.link.handed_on();
  } else {
    connection.malformed = 0;
  }
  flush(agent, now);
}

void AgentExchange::hand_on(ConnectionId id, Agent& agent,
                            AgentMessage&& message) {
  const auto& name = agent.account.name;
  if (message.component.empty())
    message.component = name;
  if (message.component != name) {
    tell(id, identity("an agent speaks as itself, not as '" +
                      excerpt(message.component) + "'"));
    return;
  }
  const auto correlation = message.correlation;
  auto error = platform_.received(name, std::move(message));
  if (error && error->kind == WireErrorKind::malformed)
    return tell_counted(id, std::move(*error), correlation);
  open_.at(id).malformed = 0;
  if (error)
    tell(id, *error, correlation);
}

// -- what leaves --------------------------------------------------------------

Expected<void> AgentExchange::send(const std::string& name,
                                   AgentMessage&& message, Timestamp now) {
  const auto found = agents_.find(name);
  if (found == agents_.end() || !found->second.is_online)
    return fail(ErrorKind::offline, "the agent " + name + " is not connected");
  // A message that cannot be written would block everything behind it.
  if (auto checked = check_numbered(message); !checked)
    return fail(ErrorKind::limit, std::move(checked.error().sentence));
  if (!found->second.link.send(std::move(message)))
    return fail(ErrorKind::limit,
                "too much waits for the agent " + name + " already");
  flush(found->second, now);
  return {};
}

void AgentExchange::flush(Agent& agent, Timestamp now) {
  // Without a connection there is no output.
  agent.link.write_output(now, [&](const AgentMessage& message) {
    connections_.write(agent.connection, message);
  });
}

bool AgentExchange::is_online(const std::string& name) const {
  const auto found = agents_.find(name);
  return found != agents_.end() && found->second.is_online;
}

bool AgentExchange::reads_json(const std::string& name) const {
  const auto found = agents_.find(name);
  return found != agents_.end() && found->second.json;
}

// -- time ---------------------------------------------------------------------

void AgentExchange::tick(Timestamp now) {
  now_ = now;
  for (const auto id : late()) {
    if (!open_.at(id).agent)
      tell(id, {WireErrorKind::unknown, "no hello came in time"});
    end(id);
  }
  for (auto& [name, agent] : agents_)
    if (agent.connection != 0)
      flush(agent, now);
    else
      see_to_absent(agent);
}

void AgentExchange::see_to_absent(Agent& agent) {
  if (now_ - agent.left >= Link::offline_after.count())
    go_offline(agent);
  give_up_if_gone(agent);
}

// The connections that have been silent for too long.
std::vector<ConnectionId> AgentExchange::late() const {
  std::vector<ConnectionId> late;
  for (const auto& [id, connection] : open_)
    if (connection.agent ? !connection.agent->link.tick(now_)
                         : now_ - connection.since >= hello_within.count())
      late.push_back(id);
  return late;
}

// An agent that stays away counts as one whose process has ended.
void AgentExchange::give_up_if_gone(Agent& agent) {
  if (agent.link.waiting() == 0 || now_ - agent.left < returns_within.count())
    return;
  const auto& name = agent.account.name;
  const Error gone{ErrorKind::offline, "the agent " + name + " stays away", {}};
  for (const auto& message : agent.link.give_up())
    platform_.refused(name, message, gone);
}

std::optional<Timestamp> AgentExchange::next_tick() const {
  std::optional<Timestamp> next;
  const auto consider = [&](Timestamp time) {
    next = next ? std::min(*next, time) : time;
  };
  for (const auto& [name, agent] : agents_)
    if (const auto time = agent.link.next_tick())
      consider(*time);
    else if (agent.is_online)
      consider(agent.left + Link::offline_after.count());
    else if (agent.link.waiting() > 0)
      consider(agent.left + returns_within.count());
  for (const auto& [id, connection] : open_)
    if (!connection.agent)
      consider(connection.since + hello_within.count());
  return next;
}

} // namespace parlour::adapters::agents
