// The world of one conversation in a test: an application compiled from XML,
// components that note down what they are told, a clock that the test moves,
// frames that answer at once as their actors would, a database made of a
// function. Acts go in as they are, so that no understanding is needed.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "script/dialogue/engine/conversation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::dialogue {

using Texts = std::vector<std::string>;

// Acts as an understanding component hands them over.
Value act(const char* kind, Value topic = {}, Map slots = {});
Value inform(Value topic, Map slots);
Value slot_value(Value value, double confidence);

struct WorldOptions {
  // Attributes and children of <settings>, besides name and scripts.
  std::string start;
  std::string sessions;
  std::string settings;
  std::uint64_t seed = 1;
  bool open = true;
  bool pipeline = true; // what ASR hears is fired
};

class World : public Port {
public:
  // `script` holds the children of <dialogue>; a handler that fires what ASR
  // hears is added to it, unless the options say otherwise.
  explicit World(const std::string& script, const WorldOptions& options = {});
  ~World() override;

  // One user turn, then the world runs until nothing moves by itself.
  void say(Value acts);
  void say(const char* generic_act);
  // The same, without letting the world run: several turns in a row.
  void queue(Value acts);
  void event(std::string source, std::string command,
             std::vector<Value> params = {}, Correlation correlation = 0);
  // One that belongs to no session: heard by who has subscribed to it.
  void broadcast(std::string source, std::string command,
                 std::vector<Value> params = {});
  void open();
  void run();
  void advance(Milliseconds time);
  // The oldest socket that is to be opened is, or fails with this text.
  void answer_socket(const std::string& failure = "");
  // The other side of a socket closes.
  void end_socket(const std::string& name, const std::string& why);

  // What was said since the last call.
  Texts said();
  // What was sent to components since then, as "Module.Command(params)".
  Texts posted();
  // Inspections of a kind since the beginning, as "subject: detail".
  Texts seen(InspectionKind kind) const;
  std::size_t timers() const {
    return timers_.size();
  }
  Value slot(const char* topic, const char* name) const {
    return conversation->slot_value(topic, name);
  }

  std::shared_ptr<const script::Program> program;
  std::unique_ptr<Conversation> conversation;
  Timestamp now;
  std::map<std::string, std::set<std::string>> components; // name -> roles
  std::vector<RoleEvent> own_events;                       // of any of them
  // The act whose best phrase cannot be computed: there is another.
  std::string fails_to_word;
  // What inline components answer; may be empty.
  std::function<std::vector<Message>(const Message&)> answers;
  std::function<Expected<ResultSet>(const QueryRequest&)> database;
  // What becomes of files; without, there are none.
  FileAccess files;
  // Sockets: what was asked for and not answered yet, what was sent, by name.
  std::deque<SocketRequest> opening;
  std::map<std::string, SocketId> sockets;
  Texts sent;
  std::vector<Subscription> subscriptions;
  std::deque<ComponentRequest> changes; // of components, to be answered
  bool hold_queries = false;
  bool hold_outputs = false; // they are played until the test says otherwise
  std::deque<QueryRequest> queries; // not answered yet
  std::deque<OutputId> playing;     // not finished yet
  std::vector<Message> messages;    // all that were posted
  bool has_ended = false;
  std::size_t steps = 0;

  // Port
  std::vector<Message> post(Message message) override;
  void subscribe(const std::vector<Subscription>& all) override {
    subscriptions = all;
  }
  bool reachable(const std::string& module) const override;
  bool is_source(const std::string& module,
                 const std::string& source) const override;
  Reply reply_to_request(const Message& event) const override;
  void release(const Output& output) override;
  void start_timer(TimerId id, Milliseconds after) override;
  void cancel_timer(TimerId id) override;
  void query(QueryRequest request) override;
  void file(QueryId id, FileRequest request) override;
  void component(ComponentRequest request) override {
    changes.push_back(std::move(request));
  }
  void open_socket(SocketRequest request) override;
  Expected<void> send_socket(SocketId id, const std::string& text) override;
  void socket_taken(SocketId id) override;
  void close_socket(SocketId id) override;
  void apply(TopicId topic, FrameRequest request) override;
  void unhandled(const Message& message) override;
  bool inspected() const override {
    return true;
  }
  void inspect(Inspection inspection) override;
  void ended() override;

private:
  bool move(); // one thing that happens by itself; false: nothing does

  test::TemporaryFolder folder_;
  std::string socket(SocketId id) const; // its name

  Texts said_;
  std::deque<std::pair<QueryId, FileRequest>> wanted_files_;
  std::size_t posted_ = 0;
  std::vector<Inspection> seen_;
  std::map<TimerId, Timestamp> timers_;
  std::map<TopicId, FramePointer> frames_;
  std::optional<FrameResult> applied_;
};

ResultSet rows(std::vector<std::string> columns, List cells);

} // namespace parlour::dialogue
