// Reconnection dials the platform again and again, after pauses that grow, for
// an agent that wants to be connected.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "adapters/agents/client/platform_dialler.hpp"
#include "adapters/loop/alarm.hpp"
#include "adapters/loop/backoff.hpp"

namespace parlour::adapters::agents {

// Used on the loop's thread.
class Reconnection {
public:
  // A pause is over: dial() again, if a connection is still wanted.
  using Retry = std::function<void()>;
  // Gets a line for the log.
  using Note = std::function<void(const std::string& text)>;

  // `loop` must outlive it. `address` is for the log.
  Reconnection(Loop& loop, std::unique_ptr<PlatformDialler> dialler,
               std::string address, Retry retry, Note note);

  // Calls `done` once, unless it dials already.
  void dial(PeerConnection::Owner& owner, PlatformDialler::Done done);
  // There is no connection. Each pause is twice as long as the one before; only
  // the first reason since the agent was last connected is noted.
  void try_later(const std::string& reason);
  // The agent is connected.
  void succeeded();
  // Nothing is dialled any more, so the loop may end.
  void stop();

private:
  const std::unique_ptr<PlatformDialler> dialler_;
  const std::string address_;
  const Note note_;
  std::optional<Alarm> alarm_; // nothing once it has stopped
  ConnectionId last_id_ = 0;
  Backoff backoff_;
  bool is_dialling_ = false;
  bool loss_is_noted_ = false;
};

} // namespace parlour::adapters::agents
