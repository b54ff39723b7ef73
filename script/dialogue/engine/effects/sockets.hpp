// ScriptSockets: the TCP clients that a session's scripts opened, by name.
// Their texts come as messages of that name, `Data` and at last `Closed`, like
// those of a component (language rules 11.9 and 11.10).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/step.hpp"
#include "script/dialogue/agenda/wait_outcome.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/inbox.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// Owned by ConversationImplementation. The connections are the port's; here is
// what the conversation knows of them.
class ScriptSockets {
public:
  explicit ScriptSockets(DialogueContext& context) : context_(context) {}

  // An error of kind Refused where the name is taken by a role or component, of
  // kind Network where the session has such a socket, or as many as it may
  // have.
  Expected<void> may_open(const std::string& name) const;
  // One that may; the wait is over when it is open or has failed (opened()).
  void open(const script::Effect& effect, WaitId wait);
  // Errors of kind Network.
  script::Performed send(const script::Effect& effect);
  script::Performed close(const script::Effect& effect);

  // What the script that waits for the socket is told; nothing where it is none
  // of these, such as one that was given up meanwhile.
  std::optional<WaitOutcome> opened(SocketId id, Expected<void> outcome);
  // By the other side: its name is free again.
  void closed(SocketId id);
  // A message has gone through the pipeline: if it is a socket's, the next may
  // come.
  void handled(const Message& message) {
    if (!sockets_.empty())
      let_next_come(message);
  }
  // The wait was ended from outside.
  void forget(WaitId wait);

  // Their connections are lost. Those of open ones are told by the event
  // Closed; the waits of those that were being opened.
  std::vector<WaitOutcome> lose_all(Inbox& inbox);

  bool waits_for_answer() const;
  bool any() const {
    return !sockets_.empty();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_);
    archive(sockets_);
  }

private:
  // The WaitId is that of the script which opens it.
  struct Socket {
    SocketId id = 0;
    WaitId opening = 0; // 0: open

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id, opening);
    }
  };
  using Entries = std::map<std::string, Socket, std::less<>>;

  Entries::iterator find(SocketId id);
  void let_next_come(const Message& message);
  Message closed_event(const std::string& name, const std::string& why) const;

  DialogueContext& context_;
  Entries sockets_;
};

} // namespace parlour::dialogue
