// InstanceScope: what a component has an instance for: the node, a seat, or a
// session.
#pragma once

#include <mutex>
#include <string>

#include "runtime/message/message.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// The supervisor changes it, and the plug-in's threads ask whom to speak for.
class InstanceScope {
public:
  // The node has no name. What is said there belongs to no session until that
  // is set.
  explicit InstanceScope(std::string name = {}, SessionId session = {});

  const std::string& name() const {
    return name_;
  }
  // The one that it speaks for. A seat without a session has its own name here,
  // by which the session manager finds the seat: a turn opens the next session.
  SessionId session() const;

  void begins(const SessionId& session);
  // Nothing happens where another has begun.
  void is_over(const SessionId& session);

private:
  const std::string name_;
  mutable std::mutex mutex_;
  SessionId session_;
};

} // namespace parlour::actors
