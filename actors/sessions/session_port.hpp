// SessionPort: carries out what a conversation wants by sending messages to
// other actors, and keeps the actors that work for it: timers, queries, topic
// frames, sockets. Owned by the session's actor and called on its thread only.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "actors/sessions/held_effects.hpp"
#include "actors/sessions/session_alarm.hpp"
#include "actors/sessions/session_parts.hpp"
#include "actors/sessions/session_sockets.hpp"
#include "actors/sessions/turn_meter.hpp"
#include "actors/support/actor_trace.hpp"
#include "script/dialogue/agenda/port.hpp"

namespace parlour::actors {

// Each effect is one message to an actor, or one call of the bus; its outcome
// comes back as a message to the session and so as an input. Without a strict
// journal effects leave at once, else they wait (held_effects.hpp): what is
// below as perform().
class SessionPort : public dialogue::Port, private InlineCaller {
public:
  // One request to a topic's frame; its answer is the session's next input,
  // before whatever else is in the mailbox.
  using AskFrame = std::function<void(
      const topic_frame_actor&, std::shared_ptr<const dialogue::FrameRequest>)>;

  // The outcome of a component() is an input of the session.
  using ComponentDone = std::function<void(dialogue::QueryId, Expected<void>)>;

  SessionPort(session_actor::pointer self,
              std::shared_ptr<const SessionParts> parts, SessionId id,
              seat_actor seat, AskFrame ask_frame = {},
              ComponentDone component_done = {});
  ~SessionPort() override; // ends whatever still works for the session
  // For the same session; nothing works for it yet.
  std::unique_ptr<SessionPort> another() const {
    return std::make_unique<SessionPort>(self_, parts_, id_, seat_, ask_frame_,
                                         component_done_);
  }

  // Returned is what this session gets of it at once: the message itself where
  // no sink takes it, and the answers of inline components.
  std::vector<Message> post(Message message) override;
  void subscribe(const std::vector<Subscription>& all) override;
  // Whether a component of the name or role is up for this session.
  bool reachable(const std::string& module) const override;
  bool is_source(const std::string& module,
                 const std::string& source) const override;
  Reply reply_to_request(const Message& event) const override;
  void release(const dialogue::Output& output) override;
  // What is wanted from here on comes back as a message to the session:
  // timer_due, query_outcome, file_outcome, socket_told; of component() by
  // ComponentDone.
  void start_timer(dialogue::TimerId id, Timestamp due,
                   dialogue::TimerOwner owner) override;
  void cancel_timer(dialogue::TimerId id) override;
  void query(dialogue::QueryRequest request) override;
  void file(dialogue::QueryId id, FileRequest request) override;
  void component(dialogue::ComponentRequest request) override;
  void open_socket(dialogue::SocketRequest request) override;
  Expected<void> send_socket(dialogue::SocketId id,
                             const std::string& text) override;
  // A text of the socket is dealt with.
  void socket_taken(dialogue::SocketId id) override;
  void close_socket(dialogue::SocketId id) override;
  // One at a time: the session takes no other input until the frame has
  // answered (engine rule 5.12).
  void apply(script::TopicId topic,
             std::shared_ptr<const dialogue::FrameRequest> request) override;
  // Counted and shown; nothing comes back.
  void unhandled(const Message& message) override;
  // Whether an inspection is worth being made.
  bool inspected() const override;
  void inspect(Inspection inspection) override;
  // To Discretion: what is private, and up to which message all is understood.
  void conceal(const std::vector<std::string>& texts) override;
  void conceal_turn() override;
  void settled(std::uint64_t received) override;
  void ended() override;

  // What it started is over by itself.
  void timer_is_over(dialogue::TimerId id);
  // On wake_up: what the engine watches rings where it is due.
  void wake() {
    alarm_.wake();
  }
  void query_is_over(dialogue::QueryId id);
  void socket_is_over(dialogue::SocketId id);
  // What a socket said as messages for the conversation, after the routes.
  std::vector<Message> hear_socket(dialogue::SocketId id,
                                   const SocketEvent& event);
  // What waits for the journal.
  HeldEffects& effects() {
    return effects_;
  }
  // To the seat, where turns are numbered.
  void tell_turns_done(std::uint64_t turn);
  // With how long they took, when what they led to has left.
  void count_turns(const TurnMeter::Answered& answered);
  // What happens from now on happens in this turn of the user.
  void turn_begins(std::uint64_t number) {
    turn_ = number;
  }
  // The topics' frames end; those that are needed again are spawned again.
  void end_frames();
  // The session goes over to another program: its topics' frames are others.
  void go_over(std::shared_ptr<const SessionParts> parts);
  // The same for one that begins again: nothing works for the one before.
  void begin_again(std::shared_ptr<const SessionParts> parts);
  // After a crash: what was posted, and may not have left.
  // With the session and correlation that they had.
  void post_again(std::vector<Message> messages);
  // -- for who asks how it is
  const SessionId& id() const {
    return id_;
  }
  // Of its script; empty: none.
  const std::string& last_error() const {
    return last_error_;
  }
  // The actors that work for it.
  std::vector<ActorHandle> children() const;
  // Says that the session is gone, and ends whatever still works for it.
  void close(std::vector<Message> unread);
  // Then: what comes late may be the seat's next session's.
  void pass_on(const std::vector<Message>& late);

private:
  // `due`: its entry in NodeTime, removed with it.
  struct Timer {
    timer_actor actor;
    DueTimes::Id due;
  };
  struct Query {
    query_actor actor;
    DueTimes::Id due;
  };

  // -- InlineCaller
  std::vector<Message> call(const Target& target,
                            const Message& message) override;
  bool keep_back(const Target& target, const SharedMessage& message) override;
  template <class Effect>
  void perform(Effect effect,
               HeldEffects::Noted noted = HeldEffects::Noted::no);
  void start_query(dialogue::QueryRequest request);
  void order_component(dialogue::ComponentRequest request);
  void end_timer(const Timer& timer);
  // Ends timers, queries, sockets and frames.
  void end_all();
  // Valid until end_all().
  const topic_frame_actor& frame_of(script::TopicId topic);
  Timestamp due_at(Milliseconds after) const;
  ActorTrace trace_of(const char* kind, const std::string& name) const;

  const session_actor::pointer self_;
  std::shared_ptr<const SessionParts> parts_;
  NodeTime& time_;
  MessageBus& bus_;
  const SessionId id_;
  const seat_actor seat_;
  const AskFrame ask_frame_;
  const ComponentDone component_done_;
  std::string last_error_;
  std::uint64_t turn_ = 0;
  HeldEffects effects_;
  SessionAlarm alarm_;
  std::map<dialogue::TimerId, Timer> timers_; // of scripts
  std::map<dialogue::QueryId, Query> queries_;
  SessionSockets sockets_;
  std::map<script::TopicId, topic_frame_actor> frames_;
};

} // namespace parlour::actors
