// MessageBus: the way of messages from whoever sends them to the mailboxes that
// get them. Made by the node, which outlives its actors.
//
// The one place for the rule that a message which waits for an answer gets
// exactly one (engine rule 1).
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "actors/protocol/interfaces.hpp"
#include "actors/routing/reply_registry.hpp"
#include "actors/routing/routing_table.hpp"
#include "actors/support/node_time.hpp"
#include "actors/support/observer.hpp"
#include "actors/support/shared_by_threads.hpp"

namespace parlour::actors {

// The event by which a component's failure answers a message.
Message failure_answer(const std::string& component, const Message& message,
                       const std::string& reason);
// The same for who waits for an answer; nothing where nobody does.
std::optional<Message> answer_for_failed(const std::string& component,
                                         const Message& message,
                                         const std::string& reason);

// Who calls components that answer in the caller's own turn (engine rule 1.2).
// Implemented by a session's port (actors/sessions/session_port.hpp); called on
// the session's thread, while the message is routed.
class InlineCaller {
public:
  virtual ~InlineCaller() = default;
  // The events that it answers with; `target.direct` is not null.
  // The bus routes these events like any message, with the same caller: "NLU
  // answers FrameInfo" needs no mailbox.
  virtual std::vector<Message> call(const Target& target,
                                    const Message& message) = 0;
  // Asked for each delivery that goes by mailbox. A session with a strict
  // journal keeps them back until the journal has what led to them (engine rule
  // 7.11).
  // True: it gives the job to the component later, by hand_over(). False: the
  // bus does it now.
  virtual bool keep_back(const Target&, const SharedMessage&) {
    return false;
  }
};

// Safe to use from any thread once the node has started.
//
// Which way in is for whom: a component publishes one event on its own thread;
// tools bring_in what comes from outside; the message centre routes what was
// brought in; a session routes what it posts, with itself as the caller.
class MessageBus {
public:
  // From another name to the role: "Record" to "Microphone".
  using Aliases = std::map<std::string, std::string, std::less<>>;

  // Nobody fills a role yet.
  MessageBus(NodeTime& time, Observer& observer,
             std::shared_ptr<const script::Program> program,
             Aliases aliases = {});
  MessageBus(const MessageBus&) = delete;
  MessageBus& operator=(const MessageBus&) = delete;

  // -- the node --------------------------------------------------------------

  // The message centre gets what sessions get.
  void connect(message_centre_actor centre);
  // Nobody gets anything any more, whoever still sends.
  // Called when the actors have ended. Threads of plug-ins that were left
  // behind may still publish: their messages vanish.
  void take_down();

  // -- the table -------------------------------------------------------------

  // Who fills which role from now on, in order of preference; the supervisor
  // says so. Nobody does when the node is down.
  void set_targets(std::vector<Target> targets);
  // Whose routes and openings count from now on.
  void set_program(std::shared_ptr<const script::Program> program);
  // What senders apply; never null.
  SharedByThreads<RoutingTable>::Pointer table() const {
    return table_.load();
  }
  // Whether it is what somebody said, as a recogniser heard it.
  bool is_heard(const Message& message) const;
  const Counters& counters() const {
    return *parts_.counters;
  }

  // -- messages --------------------------------------------------------------

  // From any thread: stamped and routed by the table at once (engine rule 1),
  // into the components' mailboxes; by the message centre what sessions get.
  // `held` may be none; what comes of the message takes it, so that it need not
  // be counted anew.
  void publish(Message&& message, Timestamp now, InFlight held);
  // Messages that happened together.
  void publish(std::vector<Message> messages);
  // Messages from outside that happened together: all of it by the message
  // centre, as who watches may bring them in while it is shown others.
  void bring_in(std::vector<Message> messages);
  // Stamped and routed, in this order; returned is what sessions get.
  std::vector<Message> route(std::vector<Message> messages);
  // The same for one message in the turn of a session, which calls inline
  // components itself, and theirs in turn; so many deep at most: what goes
  // deeper goes by mailbox.
  static constexpr int inline_depth = 8;
  std::vector<Message> route(Message message, InlineCaller& caller);
  // Puts it into the component's mailbox. Where that does not take it, it is
  // counted and shown as unhandled; returned is the event that answers it, if
  // it waits for one.
  std::optional<Message> hand_over(const Target& target,
                                   ComponentMailbox::Job job);
  // A timer of the session is due: the centre tells it.
  void ring(const session_actor& session, timer_due what);
  // The centre lets a session go that nobody finds any more, once it has what
  // was sent to it before.
  void retire(session_actor session, InFlight work);

  // -- questions -------------------------------------------------------------

  // Sends a question by the table, as every sender may (engine rule 1); false
  // where nobody is there to take it.
  bool ask(Message question, const InFlight& work);
  // Whose the answers are.
  ReplyRegistry& replies() {
    return replies_;
  }

  Observer& observer() {
    return observer_;
  }

  // -- what goes wrong -------------------------------------------------------

  // Counted, and shown or else logged: a message that nobody took.
  // Nothing where nobody has to take it. `turn`: of its session, if known.
  void unhandled(const Message& message, const std::string& why,
                 std::uint64_t turn = 0);
  // The same for the sinks of a message that nobody fills.
  void unreached(const Routed& routed);
  // Shown, or else logged: what went wrong with a message on its way.
  void failed(const Message& message, const Error& error);

private:
  // Makes a whole new table: loading is rare, and routing must not lock.
  void store(std::vector<Target> targets);
  // The taps and complaints of the table lead to the observer.
  RoutingTable::Parts parts(std::shared_ptr<const script::Program> program,
                            Aliases aliases);
  // On the way of one message and of all that answers it at once.
  struct Way {
    Timestamp now = 0;
    std::vector<Message>& for_sessions; // what sessions get
    InlineCaller* caller = nullptr;
    InFlight held = {}; // for the next delivery; may be none
  };
  // Where even the answer for a component that failed is for one that failed,
  // nobody is answered again, however the routes lead.
  enum class Answers : bool { no, yes };
  // Routes one message and delivers it, and all that answers it at once;
  // `depth` counts inline calls inside of each other.
  void carry(Message&& message, Way& way, int depth = 0,
             Answers answers = Answers::yes);
  void deliver(Delivery& delivery, Way& way, int depth, Answers answers);
  void answer_for_nobody(const std::vector<Unreached>& unreached, Way& way,
                         int depth);
  void pass_to_centre(std::vector<Message> messages);

  NodeTime& time_;
  Observer& observer_;
  // What every table has in common; without targets. `program` alone changes,
  // with `storing_` held.
  RoutingTable::Parts parts_;
  SharedByThreads<RoutingTable> table_;
  ReplyRegistry replies_;
  SharedByThreads<message_centre_actor> centre_; // null: none
  std::mutex storing_; // the table, one after the other
  std::atomic<bool> down_ = false;
};

} // namespace parlour::actors
