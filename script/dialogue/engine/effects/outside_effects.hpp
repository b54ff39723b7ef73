// OutsideEffects: what scripts want of databases, files, the network and
// whoever keeps the components. Most of it waits, holding no thread; the
// outcome comes back by answered().
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/agenda/wait_outcome.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/engine/effects/sockets.hpp"
#include "script/dialogue/engine/effects/subscriptions.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// Owned by ConversationImplementation. An effect is refused or begins a wait;
// the wait ends by answered(), by forget(), or with a deadline. Ids of what it
// asks for come from the conversation's counter, so answered() can be told
// about any outcome.
class OutsideEffects {
public:
  OutsideEffects(DialogueContext& context, Timers& timers,
                 RunningScript& running, ScriptSockets& sockets)
      : context_(context), timers_(timers), running_(running),
        sockets_(sockets), subscriptions_(context.port) {}

  // An error where the effect is none of these.
  script::Performed perform(script::Activation& activation,
                            const script::Effect& effect);

  // The outcome of a <querydb>, of a transaction's ends, a <readfile>, <load>
  // …; nothing where it is none of these.
  std::optional<WaitOutcome> answered(QueryId id, Expected<Value> outcome);
  // Something is on its way to a database, the disk, the network or the
  // supervisor.
  bool waits_for_answer() const {
    return !queries_.empty() || sockets_.waits_for_answer();
  }
  // The wait was ended from outside; an outcome that still comes is then
  // nobody's.
  void forget(WaitId wait);
  // Another port is told of the subscriptions. The waits for which nobody works
  // any more, each with what its script is told: in doubt, or done for a
  // rollback (engine rule 7.9).
  std::vector<WaitOutcome> resume();

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, timers_, running_, sockets_);
    archive(subscriptions_, queries_, connections_, current_);
  }

private:
  using Performed = script::Performed;
  using Call = const script::Effect&;

  // In what follows, `writes` says whether the activation may write without
  // naming a connection (language rule 11.12).
  Performed connect_database(script::Activation& activation, Call effect);
  Performed query_database(bool writes, Call effect);
  Performed transaction(bool writes, Call effect, QueryRequest::Kind kind);
  Performed ask_database(QueryRequest request, const Value& named);
  Performed file(FileRequest request);
  Performed open_socket(Call effect);
  Performed change_component(Call effect);

  // What a <connectdb> with a name has opened. It is no connection of the
  // database adapter: only the name that queries then use.
  struct Connection {
    // Empty: the first that fills the role Database.
    std::string component;
    bool write = false;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(component, write);
    }
  };

  // A wait for an outcome; files and components have one, too.
  struct Query {
    WaitId wait = 0;
    bool rollback = false; // never fails: the error that led to it counts

    template <class Archive>
    void serialize(Archive& archive) {
      archive(wait, rollback);
    }
  };

  DialogueContext& context_;
  Timers& timers_;
  RunningScript& running_;
  ScriptSockets& sockets_;
  Subscriptions subscriptions_;
  std::map<QueryId, Query> queries_;
  std::map<std::string, Connection, std::less<>> connections_; // with a name
  std::string current_; // the component of those without; empty: the first
};

} // namespace parlour::dialogue
