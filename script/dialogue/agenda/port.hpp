// Port: everything a conversation wants from the world, one call each. The
// session actor implements it by sending messages to other actors; tests
// implement it by noting the calls down. A call returns at once; outcomes come
// back through Conversation's inputs, with the id given here. A conversation
// that goes on with another port asks that one for what it still needs
// (Conversation::resume). The session's actor calls a conversation and its port
// on one thread only. A port must not call the conversation back from within a
// call. What a port returns at once is noted with the input, so that a replay
// can give it again (inputs/recording_port.hpp): a new function that answers at
// once needs a letter there.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/outside/files.hpp"
#include "runtime/base/outside/sockets.hpp"
#include "runtime/message/inspection.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/roles.hpp"
#include "runtime/message/subscription.hpp"
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::dialogue {

// Ids that the conversation chooses; unique within a session, and kept when it
// goes on elsewhere. 0: none.
using TimerId = std::uint64_t;
// Whom a timer rings for: a <timer> or <wait> of a script, or what the engine
// watches by itself, such as silence and deadlines.
enum class TimerOwner : std::uint8_t { script, engine };
using QueryId = std::uint64_t;
using SocketId = std::uint64_t; // a session's own

// A statement of a script or topic, or an end of a transaction, for a database
// component. Conversation::query_answered brings the outcome.
struct QueryRequest {
  enum class Kind : std::uint8_t { query, begin, commit, rollback };

  QueryId id = 0;
  Kind kind = Kind::query;
  std::string database; // a connection's name; empty: the first Database
  // Of kind `query` only, as are the values.
  std::string sql;
  List values; // bound to its `?` in order
  // Whether it may change data; else the database refuses a statement that does
  // (language rule 11.12).
  bool write = false;
};

// A <load> or <unload>.
struct ComponentRequest {
  QueryId id = 0;
  bool load = true; // else unload
  // Of a load only.
  std::string plugin;
  std::string name; // the component's; of load, empty: the plug-in's
};

// A <socket> (language rule 11.9).
struct SocketRequest {
  SocketId id = 0;
  std::string name; // the source of its messages
  SocketOrder order;
};

// Owned by whoever owns the conversation, which it outlives.
class Port {
public:
  virtual ~Port() = default;

  // A message of this session through the message centre's table: stamped,
  // routed, counted. What components that are called inline answer comes back
  // at once, in order; all other answers come as messages. A message of another
  // session returns nothing.
  virtual std::vector<Message> post(Message message) = 0;

  // From now on the session hears these of the events that belong to none, and
  // no others: `all` takes the place of what was said before.
  virtual void subscribe(const std::vector<Subscription>& all) = 0;

  // Whether some component fills this role or has this name, and is up now.
  virtual bool reachable(const std::string& module) const = 0;

  // Whether a message's source is meant by `module`: the same name, or a role
  // or alias that it fills.
  virtual bool is_source(const std::string& module,
                         const std::string& source) const = 0;

  // What an event means to the request that it answers (roles.def, and the
  // component's description of its own events).
  virtual Reply reply_to_request(const Message& event) const = 0;

  // The words leave for the seat; Conversation::output_finished follows when
  // they were played (text: at once).
  virtual void release(const Output& output) = 0;

  // Conversation::timer_fired follows at that time; at once where it is over.
  virtual void start_timer(TimerId id, Timestamp due, TimerOwner owner) = 0;
  // It may ring all the same where it has rung already: Timers ignores that.
  virtual void cancel_timer(TimerId id) = 0;
  // Conversation::query_answered follows, at the latest when `request-timeout`
  // is over.
  virtual void query(QueryRequest request) = 0;
  // Conversation::file_answered follows.
  virtual void file(QueryId id, FileRequest request) = 0;

  // Conversation::component_answered follows when it is up, or gone.
  virtual void component(ComponentRequest request) = 0;

  // Conversation::socket_opened follows, then its texts as messages, and after
  // the last one Conversation::socket_closed, if it was not closed here.
  virtual void open_socket(SocketRequest request) = 0;
  virtual Expected<void> send_socket(SocketId id, const std::string& text) = 0;
  // A text of it was dealt with. While too many are not, the adapter reads no
  // more of them (language rule 11.10).
  virtual void socket_taken(SocketId id) = 0;
  // No message of it follows.
  virtual void close_socket(SocketId id) = 0;

  // Whether filling events are computed by others, the topics' actors. Else the
  // conversation does it itself, in place, and apply() is never called.
  virtual bool applies_changes() const {
    return true;
  }
  // One request to the topic frame's actor, which keeps nothing of it;
  // Conversation::frame_applied is the next input, before any other.
  virtual void apply(TopicId topic,
                     std::shared_ptr<const FrameRequest> request) = 0;

  // No state and no handler took it: to be counted and logged.
  virtual void unhandled(const Message& message) = 0;

  // Whether anybody watches; else inspect need not be called, but for errors
  // and logs.
  virtual bool inspected() const = 0;
  virtual void inspect(Inspection inspection) = 0;

  // What is private (private="true"): these texts, and what the user is just
  // saying. Nobody who watches is shown them (engine rule 7.6).
  virtual void conceal(const std::vector<std::string>&) {}
  virtual void conceal_turn() {}
  // Nothing that was received, up to the message of that number, waits for
  // being understood: those that watch may be shown what was held back because
  // it might have turned out to be private.
  virtual void settled(std::uint64_t /*received*/) {}

  // The session is over; nothing else will be wanted.
  virtual void ended() = 0;
};

} // namespace parlour::dialogue
