// AgentExchange knows which connection belongs to which agent and what each may
// do (adapters/agents/PROTOCOL.md 3 to 5). Transports report what arrives and
// write what the exchange sends; the platform learns who is online and what was
// said.
//
//  transports --opened, arrived, closed--> AgentExchange --received--> platform
//             <-------write, close-------                <--send------
//
// It has no socket, thread or clock: its owner calls it from one thread and
// tells it the time. So it is tested without any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapters/agents/delivery/hello.hpp"
#include "adapters/agents/delivery/link.hpp"
#include "adapters/agents/delivery/peer.hpp"
#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// An agent that may connect, and how it proves that it is this agent.
struct AgentAccount {
  std::string name;
  // What the agent must say in its hello. If it is empty, no token is needed.
  std::string token;
  // The agent's key for CURVE, as Z85 text. If it is empty, the agent may use
  // any key with which it can connect.
  std::string public_key;
};

class AgentExchange {
public:
  // The transports. They must not call the exchange from within these
  // functions.
  class Connections {
  public:
    virtual ~Connections() = default;
    virtual void write(ConnectionId connection,
                       const AgentMessage& message) = 0;
    // The other side reads packed messages (adapters/agents/PROTOCOL.md 2.5).
    virtual void pack(ConnectionId connection) = 0;
    // Messages that were written before are still sent.
    virtual void close(ConnectionId connection) = 0;
  };

  // The platform. It may call send() from within these functions, and nothing
  // else.
  class Platform {
  public:
    virtual ~Platform() = default;
    virtual void online(const Hello& hello) = 0;
    virtual void offline(const std::string& agent) = 0;
    // When this returns, the message counts as handed on and is acknowledged.
    // The error, if there is one, is told to the agent: nobody takes the
    // message (`refused`), or it cannot be read (`malformed`).
    virtual std::optional<WireError> received(const std::string& agent,
                                              AgentMessage&& message) = 0;
    // A message of send() was given up: the agent has stayed away.
    virtual void refused(const std::string& agent, const AgentMessage& message,
                         const Error& error) = 0;
    // A mistake of a peer, for logs and counters.
    virtual void mistake(const std::string& peer, const WireError& error) = 0;
  };

  // A connection that has not said hello is closed after this time.
  static constexpr Milliseconds hello_within{5000};
  static constexpr std::size_t max_connections = 4000;
  // So long after an agent has gone, what waits for it is given up.
  static constexpr Milliseconds returns_within{60'000};
  // Of each agent, as many as its outbox may hold: messages are handed on at
  // once and do not collect here.
  static constexpr std::uint64_t window = Link::max_waiting;
  // A connection is closed at the last of so many mistakes in a row.
  static constexpr int max_malformed = 10;
  // Each hello may tell the platform that the agent came or went.
  static constexpr int max_hellos_per_second = 50;

  // `connections` and `platform` must outlive the exchange.
  AgentExchange(std::vector<AgentAccount> accounts, std::string incarnation,
                Connections& connections, Platform& platform);

  // A transport has accepted a connection.
  void opened(ConnectionId connection, Peer peer, Timestamp now);
  // Bytes have arrived, which need not be a whole message.
  void heard(ConnectionId connection, Timestamp now);
  // A message has arrived, or something that could not be read.
  void arrived(ConnectionId connection, Read<AgentMessage>&& message,
               Timestamp now);
  void closed(ConnectionId connection);

  // Sends a message to an agent, or keeps it for one whose connection is lost
  // for the moment. The error says that it was not sent and is left as it was:
  // Offline, or Limit if the message is too large or too many wait.
  Expected<void> send(const std::string& agent, AgentMessage&& message,
                      Timestamp now);
  bool is_online(const std::string& agent) const;
  // Whether the agent reads JSON parameters.
  bool reads_json(const std::string& agent) const;

  // To be called as time passes: for heartbeats, acknowledgements and silence.
  void tick(Timestamp now);
  // When tick() has something to do next; nothing if it never has.
  std::optional<Timestamp> next_tick() const;

private:
  struct Agent {
    AgentAccount account;
    Link link;
    // 0: there is none.
    ConnectionId connection = 0;
    // The platform counts on it, although its connection may be lost at the
    // moment.
    bool is_online = false;
    bool json = false;
    // Has been welcomed before.
    bool is_known = false;
    // When its connection was lost; meaningful while it has none.
    Timestamp left = 0;
    // The present second of hellos, and how many it has had.
    Timestamp hellos_since = 0;
    int hellos = 0;
  };
  struct Connection {
    Peer peer;
    Timestamp since = 0;
    // Null until the connection has said hello.
    Agent* agent = nullptr;
    // How many mistakes came in a row.
    int malformed = 0;
  };

  // Reports a mistake to the peer and to the platform. `answered` is the
  // correlation of the message that was the mistake.
  void tell(ConnectionId id, const WireError& error,
            std::optional<std::uint64_t> answered = {});
  // The same, and closes the connection after too many in a row.
  void tell_counted(ConnectionId id, WireError error,
                    std::optional<std::uint64_t> answered = {});
  void say_bye(ConnectionId id, Connection& connection,
               const AgentMessage& message, Timestamp now);
  void greet(ConnectionId id, const AgentMessage& message, Timestamp now);
  // Checks a hello (adapters/agents/PROTOCOL.md 3.3 and 3.4).
  Read<Hello> admit(const Connection& connection, const AgentMessage& message);
  Read<void> check_rate(Agent& agent);
  void welcome(ConnectionId id, Agent& agent, const Hello& hello,
               Timestamp now);
  void hand_on(ConnectionId id, Agent& agent, AgentMessage&& message);
  void take(ConnectionId id, Connection& connection, AgentMessage&& message,
            Timestamp now);
  void drop(ConnectionId id);
  void end(ConnectionId id);
  void lose_connection(Agent& agent);
  void go_offline(Agent& agent);
  void see_to_absent(Agent& agent);
  void give_up_if_gone(Agent& agent);
  std::vector<ConnectionId> late() const;
  void flush(Agent& agent, Timestamp now);

  Connections& connections_;
  Platform& platform_;
  std::map<std::string, Agent, std::less<>> agents_;
  std::map<ConnectionId, Connection> open_;
  // The latest time that any function was told.
  Timestamp now_ = 0;
};

} // namespace parlour::adapters::agents
