// Sockets: the TCP clients that a session's scripts opened, by name. Their
// texts come as messages of that name, `Data` and at last `Closed`, like those
// of a component.
#pragma once

#include <map>
#include <string>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/step.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
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

  bool waits_for_answer() const;

private:
  struct Socket {
    SocketId id = 0;
    WaitId opening = 0; // 0: open
  };
  using Entries = std::map<std::string, Socket, std::less<>>;

  Entries::iterator find(SocketId id);
  void let_next_come(const Message& message);

  DialogueContext& context_;
  Waits& waits_;
  Entries sockets_;
};

} // namespace parlour::dialogue
