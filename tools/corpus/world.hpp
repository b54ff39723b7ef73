// World: what a conversation has around it while it is measured: a clock that
// the player moves, a database that finds something and takes what is written
// or refuses it, frames that answer at once as their actors would. No
// component, no file, no socket. Owned by the player of one dialogue.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "script/dialogue/engine/conversation.hpp"

namespace parlour::tools::corpus {

class World : public dialogue::Port {
public:
  World(std::shared_ptr<const script::Program> program,
        std::shared_ptr<const PhraseEvaluator> phrases);
  ~World() override;

  void open();
  // One utterance of the user; then the world runs until nothing moves by
  // itself. False: it does not come to rest.
  bool say(List acts);
  bool advance(Milliseconds time);

  const dialogue::Conversation& conversation() const {
    return *conversation_;
  }
  Value slot(const std::string& topic, const std::string& name) const {
    return conversation_->slot_value(topic, name);
  }

  bool writes_succeed = true;
  std::vector<dialogue::Output> said; // all of it
  std::vector<std::string> errors;    // of scripts

  std::vector<Message> post(Message message) override;
  void subscribe(const std::vector<Subscription>&) override {}
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
  void apply(dialogue::TopicId topic, dialogue::FrameRequest request) override;
  void unhandled(const Message& message) override;
  bool inspected() const override {
    return false; // errors are told all the same
  }
  void inspect(Inspection inspection) override;
  void ended() override {}

private:
  bool run();
  bool move(); // one thing that happens by itself; false: nothing does
  Expected<ResultSet> answer(const dialogue::QueryRequest& request) const;

  std::shared_ptr<const script::Program> program_;
  Timestamp now_;
  std::unique_ptr<dialogue::Conversation> conversation_;
  std::optional<dialogue::FrameResult> applied_;
  std::deque<dialogue::OutputId> playing_;
  std::deque<dialogue::QueryRequest> queries_;
  std::deque<dialogue::QueryId> files_;
  std::deque<dialogue::QueryId> changes_; // of components
  std::deque<dialogue::SocketId> sockets_;
  std::map<dialogue::TimerId, Timestamp> timers_;
  std::map<dialogue::TopicId, dialogue::FramePointer> frames_;
};

} // namespace parlour::tools::corpus
