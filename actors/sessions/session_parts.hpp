// SessionParts: what the sessions of one node are made with. The session
// manager keeps it for them.
#pragma once

#include <functional>
#include <memory>

#include "actors/routing/message_bus.hpp"
#include "actors/support/node_time.hpp"
#include "actors/support/observer.hpp"
#include "runtime/base/outside/journal.hpp"
#include "runtime/base/outside/sockets.hpp"
#include "runtime/message/phrases.hpp"

namespace parlour::actors {

class SessionDialogue; // which is made with these

// What is referred to belongs to the node and outlives the sessions.
struct SessionParts {
  NodeTime& time;
  MessageBus& bus;
  Observer& observer;
  std::shared_ptr<const script::Program> program;
  std::shared_ptr<const PhraseEvaluator> phrases = nullptr;
  // The network; null: scripts are refused it.
  std::shared_ptr<Sockets> sockets = nullptr;
  // Keeps what enters the sessions; null: nobody does.
  std::shared_ptr<Journal> journal = nullptr;
  // What sessions want of others waits until the journal has what led to it.
  bool strict_journal = false;
  // Whom sessions write to.
  session_manager_actor manager = {};
  supervisor_actor supervisor = {};
  file_keeper_actor file_keeper = {};
  // Called after each input, on the session's thread; an error ends the
  // session. May be empty.
  std::function<Expected<void>(SessionDialogue&, Timestamp now)> after_input =
      {};
};

} // namespace parlour::actors
