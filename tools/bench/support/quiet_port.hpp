// QuietPort: a world for one conversation in which everything happens at once
// and costs nothing: words are heard when they are released, frames have no
// actors, of the timers only the last one counts. What is measured with it is
// the engine alone.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "script/dialogue/engine/conversation.hpp"

namespace parlour::tools {

class QuietPort : public dialogue::Port {
public:
  // Everything that is due without the clock moving on.
  void run(dialogue::Conversation& conversation);
  // Silence lasts until the engine does something about it.
  void be_silent(dialogue::Conversation& conversation);

  // Characters since the last call, with a blank between two outputs.
  std::size_t said() {
    return std::exchange(said_, 0);
  }
  const std::string& trouble() const { // the last error; empty: all well
    return trouble_;
  }

  std::vector<Message> post(Message) override {
    return {};
  }
  void subscribe(const std::vector<Subscription>&) override {}
  bool reachable(const std::string&) const override {
    return false;
  }
  bool is_source(const std::string& module,
                 const std::string& source) const override {
    return module == source;
  }
  Reply reply_to_request(const Message&) const override {
    return Reply::answer;
  }
  void release(const dialogue::Output& output) override;
  void start_timer(dialogue::TimerId id, Milliseconds) override {
    timer_ = id;
  }
  void cancel_timer(dialogue::TimerId) override {}
  void query(dialogue::QueryRequest) override {}
  void file(dialogue::QueryId, FileRequest) override {}
  void component(dialogue::ComponentRequest) override {}
  void open_socket(dialogue::SocketRequest) override {}
  Expected<void> send_socket(dialogue::SocketId, const std::string&) override {
    return {};
  }
  void socket_taken(dialogue::SocketId) override {}
  void close_socket(dialogue::SocketId) override {}
  bool writes_frames() const override {
    return false;
  }
  void apply(script::TopicId, dialogue::FrameRequest) override {}
  void unhandled(const Message&) override {}
  bool inspected() const override {
    return false;
  }
  void inspect(Inspection inspection) override;
  void ended() override {}

private:
  std::vector<dialogue::OutputId> playing_;
  dialogue::TimerId timer_ = 0;
  std::size_t said_ = 0;
  std::string trouble_;
};

} // namespace parlour::tools
