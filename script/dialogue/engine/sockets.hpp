// Sockets: the TCP clients that a session's scripts opened, by name. Their
// texts come as messages of that name, `Data` and at last `Closed`, like those
// of a component.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "script/dialogue/agenda/lost_wait.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/step.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/inbox.hpp"
#include "script/dialogue/context/waits.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

class ScriptSockets {
public:
  ScriptSockets(DialogueContext& context, Waits& waits)
      : context_(context), waits_(waits) {}

  Expected<void> may_open(const std::string& name) const;
  // One that may; `wait` is resumed when it is open or failed.
  void open(const script::Effect& effect, WaitId wait);
  script::Performed send(const script::Effect& effect);
  script::Performed close(const script::Effect& effect);

  void opened(SocketId id, Expected<void> outcome);
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
  std::vector<LostWait> lose_all(Inbox& inbox);

  bool waits_for_answer() const;
  bool any() const {
    return !sockets_.empty();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, waits_);
    archive(sockets_);
  }

private:
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
  Waits& waits_;
  Entries sockets_;
};

} // namespace parlour::dialogue
