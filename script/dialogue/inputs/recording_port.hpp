// RecordingPort passes everything on to another port, and notes what that one
// answers at once and what was wanted of it (port_answers.hpp).
#pragma once

#include <functional>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/inputs/port_answers.hpp"
#include "script/dialogue/inputs/wishes.hpp"

namespace parlour::dialogue {

// Stands between a conversation and its port while a journal is kept. Lives on
// the session's thread; the owner takes the answers after each input.
class RecordingPort : public Port {
public:
  // The other port outlives this one.
  explicit RecordingPort(Port& port) : port_(port) {}

  // Each output that leaves; may be empty.
  std::function<void(const Output&)> on_output;

  // What was noted since the last call. Called once after each input, as what
  // was noted is one input's.
  PortAnswers take_answers();

  std::vector<Message> post(Message message) override;
  void subscribe(const std::vector<Subscription>& all) override;
  bool reachable(const std::string& module) const override;
  bool is_source(const std::string& module,
                 const std::string& source) const override;
  Reply reply_to_request(const Message& event) const override;
  void release(const Output& output) override;
  void start_timer(TimerId id, Timestamp due, TimerOwner owner) override;
  void cancel_timer(TimerId id) override;
  void query(QueryRequest request) override;
  void file(QueryId id, FileRequest request) override;
  void component(ComponentRequest request) override;
  void open_socket(SocketRequest request) override;
  Expected<void> send_socket(SocketId id, const std::string& text) override;
  void socket_taken(SocketId id) override;
  void close_socket(SocketId id) override;
  bool applies_changes() const override;
  void apply(TopicId topic,
             std::shared_ptr<const FrameRequest> request) override;
  void unhandled(const Message& message) override;
  bool inspected() const override;
  void inspect(Inspection inspection) override;
  void conceal(const std::vector<std::string>& texts) override;
  void conceal_turn() override;
  void settled(std::uint64_t received) override;
  void ended() override;

private:
  Port& port_;
  // Questions are asked of a port that is const.
  mutable PortAnswers answers_;
  Wishes wishes_;
};

} // namespace parlour::dialogue
