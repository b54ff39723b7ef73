// The public interface for authors of plug-ins. A plug-in derives from IPlugin,
// or from the class of its role in adaptors.hpp; the platform gives it a
// PluginHost. No type of the actor framework appears here (docs/plugins.md).
//
// Threads: the platform calls one instance from one thread at a time.
// PluginHost may be called from any thread, also outside of a call, except
// where a function says otherwise.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/phrases.hpp"
#include "runtime/message/roles.hpp"
#include "runtime/message/understanding.hpp"
#include "runtime/plugin/options.hpp"

namespace parlour {

// What a plug-in says of itself: checked when it is loaded, shown by `parlour
// plugin`.
struct PluginDescription {
  std::string name;               // "SQLiteDatabase"
  std::vector<std::string> roles; // "Database"
  std::string sentence;
  std::vector<OptionDescription> options = {};
  // It derives from InlinePlugin and answers within 50 µs.
  bool is_inline = false;
  // It calls functions that block, so it is never called inline.
  bool blocks = false;
  // Commands and events beyond those of its roles.
  std::vector<RoleCommand> commands = {};
  std::vector<RoleEvent> events = {};
};

// What the platform offers to one instance. The platform owns it; it lives
// longer than the instance.
class PluginHost {
public:
  virtual ~PluginHost() = default;

  // Hands an event to the message centre. An empty source is filled in.
  virtual void fire_event(Message event) = 0;

  // Sends a message to other components, by role or name (the message's sinks).
  virtual void send_message(Message message) = 0;

  // Asks another component, by role or name (the request's only sink). The
  // callback runs once, on the plug-in's own thread, with the first event that
  // ends the request (roles.def) or with an error: Refused or Database if the
  // component refuses, Offline if no component is there, Timeout after
  // `patience`, Limit if too many are open. It does not run after stop().
  using Reaction = std::function<void(Expected<Message>)>;
  virtual void ask(Message request, Milliseconds patience,
                   Reaction reaction) = 0;

  // Runs `action` on the plug-in's own thread after the delay, unless it is
  // cancelled. When a user is simulated by piped input, an empty line waits for
  // it, but the end of the input does not: cancel a delay that has lost its
  // purpose.
  using DelayId = std::uint64_t;
  virtual DelayId after(Milliseconds delay, std::function<void()> action) = 0;
  // Cancels a delay. Call it from the plug-in's own thread; the action will not
  // run afterwards. Does nothing if it has run already.
  virtual void cancel(DelayId delay) = 0;

  // Declares that this instance is broken and cannot go on, for example because
  // its device is gone or its process has died. Requests that wait for it end
  // with an error, its later messages are dropped, and the supervisor starts
  // another instance. May be called from any thread.
  virtual void failed(const std::string& reason) = 0;

  // Declares whether this instance can take messages now; it can unless it says
  // otherwise, also while it starts. One that cannot, for example because what
  // it stands for is switched off, stays as it is: requests that wait for it
  // end with an error, and its role falls to the next component. Conversations
  // hear System.AgentOffline and AgentOnline, and their <Offline> and <Online>
  // run. May be called from any thread.
  virtual void available(bool is_available) = 0;

  virtual const Clock& clock() const = 0;
  virtual void log(const std::string& text) = 0;

  // Shared resources of the application; null if there is none.
  virtual std::shared_ptr<const UnderstandingModel> understanding() const = 0;
  virtual std::shared_ptr<const PhraseEvaluator> phrases() const = 0;
  // The values of a database column, such as "db:staff.name". May block.
  virtual Expected<std::vector<std::string>>
  column(const std::string& name) const = 0;
  // Absolute path of the run's own writable folder.
  virtual std::string data_folder() const = 0;
  // Absolute path of the application's folder.
  virtual std::string application_folder() const = 0;
};

// The base class of all plug-ins. A supervisor owns each instance and calls
// start(), then receive() for each message, then stop(), always from one thread
// at a time.
class IPlugin {
public:
  virtual ~IPlugin() = default;

  // Called once, before any message. If it returns an error, the component does
  // not come up.
  Expected<void> start(PluginHost& host, const Options& options);

  // Handles a message from an agent, a component, a script or the console. If
  // it throws, the supervisor replaces the instance.
  void receive(const Message& message);

  virtual void stop() {}

protected:
  virtual Expected<void> on_start(const Options&) {
    return {};
  }
  virtual void on_message(const Message& message) = 0;

  // Fires an event that answers the message being handled: session and
  // correlation are copied from it.
  void fire_event(std::string command, std::vector<Value> params = {});
  // The same for a message that was handled earlier.
  void answer(const Message& to, std::string command,
              std::vector<Value> params = {});
  void send_message(Message message);
  // Runs `action`; the events that it fires answer `earlier`.
  void as_answer_to(const Message& earlier,
                    const std::function<void()>& action);
  // A copy of the message being handled, to answer it later. Outside of a call
  // it is an empty message without a session.
  Message current() const;
  // Asks another component in the session of the message being handled
  // (PluginHost::ask), with the default request timeout.
  void ask(std::string module, std::string command, std::vector<Value> params,
           PluginHost::Reaction reaction);

  PluginHost& host() const {
    return *host_;
  }

private:
  PluginHost* host_ = nullptr;
  const Message* current_ = nullptr; // set while it is handled
};

// An event with which an InlinePlugin answers a message.
struct Answer {
  std::string command;
  std::vector<Value> params;
};

// A plug-in whose answers depend on the message alone: no input or output, and
// no state that changes. The platform may call answers() in a session's own
// turn, from several threads at once (engine rule 1.2).
class InlinePlugin : public IPlugin {
public:
  virtual std::vector<Answer> answers(const Message& message) const = 0;

protected:
  void on_message(const Message& message) final;
};

// How to create instances of a plug-in that is part of the program or of a
// loaded library.
struct PluginFactory {
  PluginDescription description;
  std::function<std::unique_ptr<IPlugin>()> create;
};

} // namespace parlour
