// The one public door for plug-in authors: the generic component contract
// (paper III.D: IPlugin with OnMessage, FireEvent, SendMessage). No CAF type
// appears here.
//
// Threads: the platform calls one instance from one thread at a time.
// PluginHost may be called from any thread, also later than on_message.
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
#include "runtime/base/message.hpp"
#include "runtime/base/phrases.hpp"
#include "runtime/base/roles.hpp"
#include "runtime/base/understanding.hpp"
#include "runtime/plugin/options.hpp"

namespace parlour {

struct PluginDescription {
  std::string name;               // "SQLiteDatabase"
  std::vector<std::string> roles; // "Database"
  std::string sentence;
  std::vector<OptionDescription> options = {};
  // Derives from InlinePlugin, and answers within 50 µs.
  bool is_inline = false;
  // Calls libraries that block: never called inline.
  bool blocks = false;
  // What it understands and fires beyond its roles.
  std::vector<RoleCommand> commands = {};
  std::vector<RoleEvent> events = {};
};

// What the platform offers to a plug-in.
class PluginHost {
public:
  virtual ~PluginHost() = default;

  // Hands an event to the message centre. source is filled in when empty.
  virtual void fire_event(Message event) = 0;

  // To a remote agent, or to another component, by role or name (the message's
  // sinks).
  virtual void send_message(Message message) = 0;

  // Asks another component, by role or name (the request's only sink). Calls
  // back once, on the plug-in's own thread, with the first event that ends the
  // request (roles.def), or an error: of kind Refused or Database when the
  // component says no, Offline when nobody is there, Timeout after `patience`.
  // A plug-in that has stopped is not called.
  using Reaction = std::function<void(Expected<Message>)>;
  virtual void ask(Message request, Milliseconds patience,
                   Reaction reaction) = 0;

  // Calls back on the plug-in's own thread, unless it is cancelled before. An
  // empty line of a run by pipe waits for it, its end does not: cancel what has
  // lost its purpose.
  using DelayId = std::uint64_t;
  virtual DelayId after(Milliseconds delay, std::function<void()> action) = 0;
  // From the plug-in's own thread: no call comes any more. Nothing happens
  // where it has come already.
  virtual void cancel(DelayId delay) = 0;

  // This very instance is broken and cannot go on: its device is gone, its
  // process has died. Whoever waits for its answers is told; what it says from
  // now on is dropped, and another instance takes its place. From any thread.
  virtual void failed(const std::string& reason) = 0;

  virtual const Clock& clock() const = 0;
  virtual void log(const std::string& text) = 0;

  // Resources shared by the platform (paper III.D); empty where there is none.
  virtual std::shared_ptr<const UnderstandingModel> understanding() const = 0;
  virtual std::shared_ptr<const PhraseEvaluator> phrases() const = 0;
  virtual Expected<std::vector<std::string>>
  column(const std::string& name) const = 0;
  // The run's own writable folder, absolute.
  virtual std::string data_folder() const = 0;
  // The application's folder, absolute.
  virtual std::string application_folder() const = 0;
};

class IPlugin {
public:
  virtual ~IPlugin() = default;

  // Once, before any message. An error keeps the component from coming up.
  Expected<void> start(PluginHost& host, const Options& options);

  // A message from an agent, a component, a script or the console. Exceptions
  // are caught by the component's supervisor.
  void receive(const Message& message);

  virtual void stop() {}

protected:
  virtual Expected<void> on_start(const Options&) {
    return {};
  }
  virtual void on_message(const Message& message) = 0;

  // Fires an event as the answer to the message being handled: its session and
  // correlation are copied.
  void fire_event(std::string command, std::vector<Value> params = {});
  // The same for a message that was handled earlier.
  void answer(const Message& to, std::string command,
              std::vector<Value> params = {});
  void send_message(Message message);
  // Runs `action`, whose events are answers to a message that was handled
  // earlier.
  void as_answer_to(const Message& earlier,
                    const std::function<void()>& action);
  // The message being handled, for later; one without a session between two.
  Message current() const;
  // Asks a service of another component, in the session of the message being
  // handled (PluginHost::ask).
  void ask(std::string module, std::string command, std::vector<Value> params,
           PluginHost::Reaction reaction);

  PluginHost& host() const {
    return *host_;
  }

private:
  PluginHost* host_ = nullptr;
  const Message* current_ = nullptr; // while it is handled
};

struct Answer {
  std::string command;
  std::vector<Value> params;
};

// A plug-in whose answers follow from the message alone, without input, output
// or state that changes: the platform may ask it in a session's own turn, from
// several threads at once (engine rule 1).
class InlinePlugin : public IPlugin {
public:
  virtual std::vector<Answer> answers(const Message& message) const = 0;

protected:
  void on_message(const Message& message) final;
};

// A plug-in that is part of the program, or of a library that was loaded.
struct PluginFactory {
  PluginDescription description;
  std::function<std::unique_ptr<IPlugin>()> create;
};

} // namespace parlour
