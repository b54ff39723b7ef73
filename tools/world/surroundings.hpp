// Surroundings is everything around one conversation, without actors, threads
// or a real clock: it notes what the conversation wants, and answers when it is
// run, one thing at a time, in the order in which a session's actor would hear
// of these things.
//
//  Surroundings world(program);
//  world.database = [](const QueryRequest&) { return rows; };
//  world.conversation = std::make_unique<Conversation>(program, {}, world);
//  world.conversation->open(world.now);
//  world.run();
//
// The same inputs lead to the same outputs. What a user may change is public.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/inputs/session_input.hpp"

namespace parlour::tools {

// Not thread-safe. It owns the conversation, which refers to it.
class Surroundings : public dialogue::Port {
public:
  explicit Surroundings(std::shared_ptr<const script::Program> its_program);
  ~Surroundings() override;

  // Runs until nothing happens by itself. False if that does not end.
  [[nodiscard]] bool run();
  // Moves the clock, fires the timers that are due on the way, and runs after
  // each. False as for run().
  [[nodiscard]] bool advance(Milliseconds time);
  // Gives the conversation an input, now. What the world does itself goes this
  // way, too.
  virtual void take(dialogue::SessionInput input);
  // Forgets what the conversation has asked for: it goes on in a fresh world,
  // as in another process, when it resumes.
  void forget();
  // Timers that have not rung.
  std::size_t timers() const {
    return timers_.size();
  }

  std::shared_ptr<const script::Program> program;
  // Null until the user has made one.
  std::unique_ptr<dialogue::Conversation> conversation;
  Timestamp now;

  // -- who is there -----------------------------------------------------------

  // Components by name, with the roles that each fills.
  std::map<std::string, std::set<std::string>> components;
  // Events of components beside those of the roles.
  std::vector<RoleEvent> own_events;
  // Topics' frames are actors of their own; otherwise the conversation computes
  // all changes itself.
  bool has_frame_actors = true;

  // -- what answers -----------------------------------------------------------

  // What inline components answer; empty: nothing.
  std::function<std::vector<Message>(const Message&)> answers;
  // By default every query finds no row.
  std::function<Expected<ResultSet>(const dialogue::QueryRequest&)> database =
      [](const auto&) { return ResultSet{}; };
  // If these are empty, requests wait until the user answers them.
  FileAccess files;
  std::function<Expected<void>(const dialogue::SocketRequest&)> network;
  std::function<Expected<void>(const dialogue::ComponentRequest&)> changer;
  // Told of each output when it is released.
  std::function<void(const dialogue::Output&)> hears;
  // Told of each inspection; errors are inspected in any case, the others only
  // if `inspects_all`.
  std::function<void(const Inspection&)> sees;
  bool inspects_all = false;

  // -- what has not been answered ---------------------------------------------

  bool hold_queries = false;
  // Outputs play until the user ends them.
  bool hold_outputs = false;
  std::deque<dialogue::QueryRequest> queries;
  std::deque<dialogue::OutputId> playing;
  std::deque<std::pair<dialogue::QueryId, FileRequest>> wanted_files;
  std::deque<dialogue::ComponentRequest> changes;
  std::deque<dialogue::SocketRequest> opening;

  // -- what has happened ------------------------------------------------------

  std::vector<Subscription> subscriptions;
  bool has_ended = false;
  std::size_t steps = 0;

  // Port
  std::vector<Message> post(Message message) override;
  void subscribe(const std::vector<Subscription>& all) override;
  bool reachable(const std::string& module) const override;
  bool is_source(const std::string& module,
                 const std::string& source) const override;
  Reply reply_to_request(const Message& event) const override;
  void release(const dialogue::Output& output) override;
  void start_timer(dialogue::TimerId id, Timestamp due,
                   dialogue::TimerOwner owner) override;
  void cancel_timer(dialogue::TimerId id) override;
  void query(dialogue::QueryRequest request) override;
  void file(dialogue::QueryId id, FileRequest request) override;
  void component(dialogue::ComponentRequest request) override;
  void open_socket(dialogue::SocketRequest request) override;
  Expected<void> send_socket(dialogue::SocketId id,
                             const std::string& text) override;
  void socket_taken(dialogue::SocketId id) override;
  void close_socket(dialogue::SocketId id) override;
  bool applies_changes() const override;
  void apply(dialogue::TopicId topic,
             std::shared_ptr<const dialogue::FrameRequest> request) override;
  void unhandled(const Message& message) override;
  bool inspected() const override;
  void inspect(Inspection inspection) override;
  void ended() override;

protected:
  // Called before each thing that happens; may replace the conversation.
  virtual void before_move() {}

private:
  bool move();
  bool answer_request();

  std::map<dialogue::TimerId, Timestamp> timers_;
  std::optional<dialogue::FrameResult> applied_;
};

} // namespace parlour::tools
