// AgentServer is what remote agents connect to. It owns a loop on which the
// transports and the exchange run. Each component of a remote agent attaches
// itself under the agent's name.
//
//  agents <-> transports <-> AgentExchange <-> components
//            '-------- one thread -------'     send() from any thread
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/agents/delivery/exchange.hpp"
#include "adapters/agents/lines/line_listener.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

struct ServerOptions {
  std::vector<AgentAccount> accounts;
  std::optional<LineOptions> lines;
  // ZeroMQ, if this program was built with it.
  struct ZeroMQ {
    std::string address = "tcp://127.0.0.1:*";
    std::string secret_key;
    std::vector<std::string> allowed_keys;
  };
  std::optional<ZeroMQ> zeromq;
  // Gets lines about mistakes of peers, also of those that have not said who
  // they are. Called on the server's thread; may be empty.
  std::function<void(const std::string& line)> log = {};
};

// Thread-safe.
class AgentServer {
public:
  // The component of one agent. Its functions are called on the server's thread
  // and must not block; none is called after detach() has returned. They may
  // call send() and attach(), but not detach(), which waits for them.
  class Component {
  public:
    virtual ~Component() = default;
    virtual void online(const Hello& hello) = 0;
    virtual void offline() = 0;
    // The error, if there is one, is told to the agent (AgentExchange).
    virtual std::optional<WireError> received(AgentMessage message) = 0;
    // A message of send() could not be delivered. Only its session, correlation
    // and command are filled in.
    virtual void refused(const AgentMessage& message, const Error& error) = 0;
    // One of the functions above has thrown, or the server has while it did
    // something for the agents. The component is detached by then: nothing else
    // is called.
    virtual void failed(const std::string& reason) noexcept = 0;
  };

  // Starts to listen. The error, of kind Settings, Network or Limit, means that
  // nothing was started.
  static Expected<std::unique_ptr<AgentServer>> start(ServerOptions options);
  // Closes every connection and ends the thread.
  ~AgentServer();

  // Where agents connect, such as "tcp://127.0.0.1:5670": first for lines, then
  // for ZeroMQ.
  std::vector<std::string> addresses() const;

  // How many mistakes of each kind (adapters/agents/PROTOCOL.md 5) there were
  // since the start, and under "accept" how often no connection could be
  // accepted, because the process had too many files open.
  std::map<std::string, std::uint64_t> mistakes() const;

  // Replaces the component of this name. It is told at once if its agent is
  // online.
  void attach(const std::string& agent, std::shared_ptr<Component> component);
  // Does nothing if another component has taken the place. Waits for a call
  // into the component to return.
  void detach(const std::string& agent, const Component* component);
  // Queues a message for the agent. Never blocks; a failure is reported by
  // refused().
  void send(const std::string& agent, AgentMessage message);

private:
  class Implementation;
  explicit AgentServer(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

} // namespace parlour::adapters::agents
