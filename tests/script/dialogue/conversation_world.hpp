// World: the surroundings of a conversation (tools/world) for tests. It
// compiles an application from XML and records what is said and what components
// and sockets are sent. The test enters acts directly, so no understanding is
// needed. What does not come to rest throws.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "script/dialogue/inputs/recording_port.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/world/surroundings.hpp"

namespace parlour::dialogue {

using Texts = std::vector<std::string>;

// Acts as an NLU component reports them.
Value act(const char* kind, Value topic = {}, Map slots = {});
Value inform(Value topic, Map slots);
Value slot_value(Value value, double confidence);

struct WorldOptions {
  // Attributes and children of <settings>, beside name and scripts.
  std::string start;
  std::string sessions;
  std::string settings;
  std::uint64_t seed = 1;
  bool open = true;
  bool pipeline = true; // fire what ASR recognises
  // Before each move another conversation takes the place of this one and goes
  // on from its bytes; everywhere where PARLOUR_TEST_RESTORES is set. Where
  // nothing but timers is outstanding, the world is a fresh one, too.
  bool restores = false;
  // Where PARLOUR_TEST_TAKES_OVER is set, its own program takes over before
  // each message and timer that comes to a conversation at rest.
};

class World : public tools::Surroundings {
public:
  // `script` holds the children of <dialogue>. If options.pipeline, a handler
  // is added that fires what ASR recognises.
  explicit World(const std::string& script, const WorldOptions& options = {});
  ~World() override; // repeats it all from what was noted

  // Enters a user turn, then runs until nothing moves by itself.
  void say(Value acts);
  void say(const char* generic_act);
  // Enters a user turn without running, for several turns in a row.
  void queue(Value acts);
  void event(std::string source, std::string command,
             std::vector<Value> params = {}, Correlation correlation = 0);
  // An event that belongs to no session: only subscribers get it.
  void broadcast(std::string source, std::string command,
                 std::vector<Value> params = {});
  void open();
  void run();
  void advance(Milliseconds time);
  // Another conversation goes on from the bytes of this one in a fresh world:
  // nobody knows of what was asked before.
  void interrupt();
  // The conversation, which is at rest, goes on with another script. Returned
  // is what is lost.
  Texts change_script(const std::string& script,
                      const WorldOptions& options = {});
  // The oldest socket that waits is opened, or fails with this text.
  void answer_socket(const std::string& failure = "");
  // The other side closes a socket.
  void end_socket(const std::string& name, const std::string& why);

  // What was said since the last call.
  Texts said();
  // What was sent to components since the last call, as
  // "Module.Command(params)".
  Texts posted();
  // All inspections of a kind, as "subject: detail".
  Texts seen(InspectionKind kind) const;
  Value slot(const char* topic, const char* name) const {
    return conversation->slot_value(topic, name);
  }

  // False: this test does something with its conversation that is no input.
  bool repeats = true;
  // The act whose best phrase fails to be computed; another one is used then.
  std::string fails_to_word;
  // Sockets that are open, and what was sent to them.
  std::map<std::string, SocketId> sockets;
  Texts sent;
  std::vector<Message> messages; // all that were posted

  void take(SessionInput input) override;

  // Port
  std::vector<Message> post(Message message) override;
  Expected<void> send_socket(SocketId id, const std::string& text) override;
  void socket_taken(SocketId id) override;
  void close_socket(SocketId id) override;

  // Another script's dialogue begins in the place of this one.
  void begin_instead(const std::string& script,
                     const WorldOptions& options = {});

private:
  World(const test::TemporaryFolder& folder, const std::string& script,
        const WorldOptions& options);
  void before_move() override;
  void repeat() const;
  void restore();
  Texts take_over(std::shared_ptr<const script::Program> other);
  std::string socket(SocketId id) const; // its name

  Conversation::Options options_;
  bool restores_;
  bool takes_over_;
  RecordingPort port_{*this};
  std::vector<std::pair<std::string, std::string>> notes_; // input, answers
  Texts said_;
  std::size_t posted_ = 0;
  std::vector<Inspection> seen_;
};

ResultSet rows(std::vector<std::string> columns, List cells);

} // namespace parlour::dialogue
