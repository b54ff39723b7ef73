// PlatformTalk is what an agent says of itself to the platform, and what the
// platform's messages mean: for the connection, or for the agent
// (adapters/agents/PROTOCOL.md 3 to 5). It opens and closes nothing.
#pragma once

#include "adapters/agents/client/shared_link.hpp"
#include "adapters/agents/delivery/hello.hpp"
#include "adapters/agents/delivery/peer_connection.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

// Used on the connection's thread.
class PlatformTalk {
public:
  // Learns what a message means.
  class Owner {
  public:
    virtual ~Owner() = default;
    // The platform knows the agent: messages may be exchanged.
    virtual void welcomed() = 0;
    // A message for the agent, which may be an error with a correlation.
    virtual void received(AgentMessage&& message) = 0;
    // A line for the log.
    virtual void note(const std::string& text) = 0;
    // The connection is of no use any more; another one may be.
    virtual void lose(const std::string& reason) = 0;
    // The platform does not want this agent, or speaks no version of it.
    virtual void end(const Error& reason) = 0;
  };

  // `link` and `owner` must outlive it.
  PlatformTalk(Hello hello, SharedLink& link, Owner& owner);

  // What follows writes to `connection`, which is the agent's only one and has
  // begun to read.
  void say_hello(PeerConnection& connection, bool reads_packed);
  // `now`: when it was heard.
  void take(PeerConnection& connection, Read<AgentMessage>&& message,
            Timestamp now);

private:
  void take_message(PeerConnection& connection, AgentMessage&& message,
                    Timestamp now);
  void take_welcome(PeerConnection& connection, const AgentMessage& message);
  void take_error(const AgentMessage& message);
  void hand_on(PeerConnection& connection, AgentMessage&& message,
               Timestamp now);
  void tell(PeerConnection& connection, const WireError& error);
  void write_error(PeerConnection& connection, const WireError& error) const;

  Hello hello_;
  SharedLink& link_;
  Owner& owner_;
  // The platform's mistakes, in a row, and when there last was one.
  int mistakes_ = 0;
  Timestamp noted_ = 0;
};

} // namespace parlour::adapters::agents
