// SessionPort: carries out what a conversation wants by sending messages to
// other actors. Lives in the session's actor and is called on its thread.
#pragma once

#include <map>

#include "actors/sessions/session_parts.hpp"
#include "actors/sessions/session_sockets.hpp"
#include "script/dialogue/agenda/port.hpp"

namespace parlour::actors {

struct session_state;

class SessionPort : public dialogue::Port {
public:
  using Self = session_actor::stateful_pointer<session_state>;

  SessionPort(Self self, std::shared_ptr<const SessionParts> parts,
              SessionId id, seat_actor seat);
  ~SessionPort() override; // ends whatever still works for the session

  std::vector<Message> post(Message message) override;
  void subscribe(const std::vector<Subscription>& all) override;
  bool reachable(const std::string& module) const override;
  bool is_source(const std::string& module,
                 const std::string& source) const override;
  Reply reply_to_request(const Message& event) const override;
  void release(const dialogue::Output& output) override;
  void start_timer(dialogue::TimerId id, Milliseconds after) override;
  void cancel_timer(dialogue::TimerId id) override;
  void query(dialogue::QueryRequest request) override;
  void file(dialogue::QueryId id, FileRequest request) override;
  void component(dialogue::ComponentRequest request) override;
  void open_socket(dialogue::SocketRequest request) override;
  Expected<void> send_socket(dialogue::SocketId id,
                             const std::string& text) override;
  void socket_taken(dialogue::SocketId id) override;
  void close_socket(dialogue::SocketId id) override;
  void apply(script::TopicId topic, dialogue::FrameRequest request) override;
  void unhandled(const Message& message) override;
  bool inspected() const override;
  void inspect(Inspection inspection) override;
  void conceal(const std::vector<std::string>& texts) override;
  void conceal_turn() override;
  void settled(std::uint64_t received) override;
  void ended() override;

  // What it started is over by itself.
  void timer_is_over(dialogue::TimerId id);
  void query_is_over(dialogue::QueryId id);
  void socket_is_over(dialogue::SocketId id);
  // What a socket said as messages for the conversation, after the routes.
  std::vector<Message> hear_socket(dialogue::SocketId id,
                                   const SocketEvent& event);
  // Says that the session is gone, and ends whatever still works for it.
  void close(std::vector<Message> unread);

private:
  struct Timer {
    timer_actor actor;
    DueTimes::Id due;
  };
  struct Query {
    query_actor actor;
    DueTimes::Id due;
  };

  void carry(Message message, std::vector<Message>& back, int depth = 0,
             Answers answers = Answers::yes);
  std::vector<Message> ask_directly(const Target& target,
                                    const Message& message);
  void end_timer(const Timer& timer);
  void end_all();
  const topic_frame_actor& frame_of(script::TopicId topic);
  Timestamp due_at(Milliseconds after) const;

  Self self_;
  const std::shared_ptr<const SessionParts> parts_;
  NodeTime& time_;
  MessageBus& bus_;
  const SessionId id_;
  const seat_actor seat_;
  std::map<dialogue::TimerId, Timer> timers_;
  std::map<dialogue::QueryId, Query> queries_;
  SessionSockets sockets_;
  std::map<script::TopicId, topic_frame_actor> frames_;
};

} // namespace parlour::actors
