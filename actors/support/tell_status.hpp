// How an actor answers get_status: with what is the same for all, and what it
// knows itself. Called by the actor, on its thread.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "actors/protocol/interfaces.hpp"

namespace parlour::actors {

struct OwnStatus {
  std::string name = {};
  std::string doing = "waits";
  std::string last_error = {};
  std::vector<ActorHandle> children = {};
};

// `self`: a stateful actor; its state's name is the kind.
template <class Self>
status_told tell_status(Self self, const get_status& what, OwnStatus own = {}) {
  ActorStatus status;
  status.kind = self->name();
  status.name = std::move(own.name);
  status.doing = std::move(own.doing);
  status.queue = self->mailbox().size();
  status.last_error = std::move(own.last_error);
  return {what.number, std::move(status), std::move(own.children)};
}

} // namespace parlour::actors
