// AgentConnection is an agent's side of the protocol: it connects to the
// platform, says hello, and connects again whenever the connection is lost
// (adapters/agents/PROTOCOL.md). It has a thread of its own, so that heartbeats
// go on while the agent is busy.
#pragma once

#include <memory>
#include <string>

#include "adapters/agents/client/platform_dialler.hpp"
#include "adapters/agents/delivery/hello.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

class AgentConnection {
public:
  // Learns what happens, on the connection's thread; must not block.
  class Listener {
  public:
    virtual ~Listener() = default;
    // A message of the platform, which may be an error with a correlation. For
    // each that has a number handed_on() must be called once, in their order,
    // when it has been dealt with.
    virtual void received(AgentMessage message) = 0;
    // A line for the log: the connection stands, or is lost.
    virtual void note(const std::string& text) = 0;
    // There has been no connection for three seconds: nobody answers requests.
    // Called again and again until there is one.
    virtual void offline() = 0;
    // The platform does not want this agent, or speaks no version of it; to
    // connect again would not help. Or one of these functions has thrown; then
    // the kind is Thrown. Nothing follows.
    virtual void rejected(const Error& error) = 0;
  };

  // `listener` must outlive it. The error, of kind Settings, names a file that
  // cannot be read.
  static Expected<std::unique_ptr<AgentConnection>>
  open(const PlatformAddress& address, const Hello& hello, Listener& listener);
  // Waits for acknowledgements, for at most a second, and says goodbye.
  ~AgentConnection();

  // The following are safe from any thread.

  // Queues a message, also while there is no connection. False: too much waits.
  bool send(AgentMessage message);
  // For authors who would rather wait than be refused: until half of what may
  // wait is free. False: that took longer. Not on the connection's thread,
  // which alone makes room.
  bool wait_for_room(Milliseconds patience);
  void handed_on();
  // False: says goodbye, and stays away until it is told to return.
  void set_present(bool is_present);

private:
  class Implementation;
  explicit AgentConnection(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

} // namespace parlour::adapters::agents
