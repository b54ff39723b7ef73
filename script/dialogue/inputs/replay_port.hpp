// ReplayPort: the surroundings of a conversation that is repeated. It gives the
// answers that were noted (port_answers.hpp), computes topics' frames itself,
// and wants to be told nothing else. What was noted and what is asked now may
// differ; it goes on with empty answers then, and says so.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/inputs/port_answers.hpp"
#include "script/dialogue/inputs/wishes.hpp"

namespace parlour::dialogue {

// Owned by a Replay. Nothing leaves it: timers do not ring, queries are not
// asked; all outcomes are inputs that were noted. Not thread-safe.
class ReplayPort : public Port {
public:
  explicit ReplayPort(std::shared_ptr<const script::Program> program);

  // The answers to what the next input asks. To be called before each input.
  void expect(PortAnswers answers);
  // Nobody has noted them: this port, which must outlive the input, is asked
  // what is answered at once, and told nothing else; what is sent by a socket
  // counts as sent. Until expect() is called.
  void ask(Port& port);
  // After the input: how what happened differs from what was noted, if it does.
  // A phrase for people; nothing where both are the same, or where a port was
  // asked.
  std::optional<std::string> difference() const;
  // The result of the frame that is awaited; empty where none is.
  FrameResult take_frame();

  // All may be empty; inspections are made only if somebody watches.
  std::function<void(const Output&)> on_output;
  // What was posted, if nobody answered it at once.
  std::function<void(const Message&)> on_post;
  std::function<void(const Inspection&)> on_inspection;
  // Of what is private: these texts, and with none what the user just said.
  std::function<void(const std::vector<std::string>&)> on_secret;

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
  void socket_taken(SocketId) override {}
  void close_socket(SocketId id) override;
  void apply(TopicId topic,
             std::shared_ptr<const FrameRequest> request) override;
  void unhandled(const Message& message) override;
  bool inspected() const override;
  void inspect(Inspection inspection) override;
  void conceal(const std::vector<std::string>& texts) override;
  void conceal_turn() override;
  void ended() override;

private:
  // The next noted answer, if it is one of these; else '\0'.
  char next(const char* letters) const;

  const std::shared_ptr<const script::Program> program_;
  Port* asked_ = nullptr; // null: what was noted counts
  PortAnswers noted_;
  // The next of the letters. Mutable, like `strayed_`, as questions are asked
  // of a port that is const.
  mutable std::size_t at_ = 0;
  // Something was asked to which the next letter is no answer: from there on
  // the notes fit nothing.
  mutable bool strayed_ = false;
  std::size_t posts_ = 0;
  std::size_t failures_ = 0;
  Wishes wishes_;
  // What apply() has computed, until the next input brings it.
  std::optional<FrameResult> frame_;
};

} // namespace parlour::dialogue
