#include "runtime/plugin/conformance.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "runtime/message/replies.hpp"
#include "runtime/plugin/description_check.hpp"
#include "runtime/plugin/parameters.hpp"
#include "runtime/plugin/test_host.hpp"

namespace parlour {

namespace {

using Steady = std::chrono::steady_clock;

constexpr const char* trial_session = "trial";
constexpr const char* unknown_command = "NoSuchCommand";

// One instance under test. Appends what is wrong to `findings`.
class TestedInstance {
public:
  TestedInstance(const PluginFactory& factory, const TestOptions& options,
                 std::vector<std::string>& findings)
      : description_(factory.description), options_(options),
        findings_(findings) {
    host_.data = options.data_folder;
    host_.application = options.application_folder;
    call("making it", [&] { plugin_ = factory.create(); });
    if (!plugin_)
      report("its factory makes nothing");
  }
  ~TestedInstance() {
    if (plugin_)
      call("stop", [&] { plugin_->stop(); });
  }

  // An instance that does not start is not tested further.
  bool start() {
    Expected<void> started = fail(ErrorKind::settings, "");
    if (plugin_ &&
        call("start",
             [&] { started = plugin_->start(host_, options_.options); }) &&
        !started)
      report("it does not start: " + started.error().message);
    started_ = Steady::now();
    return started.has_value();
  }

  // A component that is asked in a session's own turn is called by another
  // interface (InlinePlugin), so the description and the class have to agree.
  void check_kind() {
    const bool is = dynamic_cast<const InlinePlugin*>(plugin_.get()) != nullptr;
    if (description_.is_inline && !is)
      report("it is described as inline, but does not derive from "
             "InlinePlugin");
  }

  // Sends the command with sample parameters, then without any.
  void check_command(const Role& role, const RoleCommand& command) {
    const auto parameters = read_parameters(command.parameters);
    std::vector<Value> samples;
    for (const auto& parameter : parameters)
      samples.push_back(sample_of(parameter));
    const auto answer = tell(command.name, samples, command.answered);
    if (command.answered && answer.empty())
      report(command.name + to_string(Value(samples)) +
             " is not answered in time by " + endings(role));
    const bool needs =
        std::ranges::any_of(parameters, [](const Parameter& parameter) {
          return !parameter.optional && !parameter.repeats;
        });
    if (needs)
      check_bare(role, command);
  }

  void check_unknown_command() {
    if (!is_refusal(tell(unknown_command, {}, true)))
      report(
          "a command that it does not know is not refused, by Failed(reason) "
          "or as its role says no");
  }

private:
  // Sends the command without its parameters, which must be refused if the role
  // has an event for refusals.
  void check_bare(const Role& role, const RoleCommand& command) {
    const auto no =
        std::ranges::find(role.events, Reply::refusal, &RoleEvent::reply);
    const auto answer = tell(command.name, {}, command.answered);
    if (!command.answered)
      return;
    if (answer.empty())
      report(command.name + " without its parameters is not answered in time");
    else if (no != role.events.end() && !is_refusal(answer))
      report(command.name + " without its parameters is answered by " + answer +
             " instead of " + no->name);
  }

  // Sends the command and returns the name of the event that ends the request;
  // empty if none comes in time.
  std::string tell(const std::string& command, std::vector<Value> params,
                   bool is_answered) {
    Message message;
    message.source = "Script";
    message.command = command;
    message.params = std::move(params);
    message.session = trial_session;
    message.correlation = ++correlation_;
    std::string answer;
    if (!call(command, [&] { plugin_->receive(message); }))
      return answer;
    auto answered = [&] {
      for (const auto& event : host_.take_events())
        if (check_event(command, event) && answer.empty())
          answer = event.command;
      return !answer.empty();
    };
    const auto patience = answer_time();
    if (is_answered)
      call(
          command, [&] { host_.wait(answered, patience); }, patience);
    else
      answered();
    return answer;
  }

  // Checks an event that was fired during a command. Returns true if it ends
  // the request that was made last.
  bool check_event(const std::string& command, const Message& event) {
    const auto reply = reply_of(event.command);
    if (!reply)
      report_once("it fires " + event.command +
                  ", which neither its roles nor its description know");
    if (event.correlation == correlation_ && event.session != trial_session)
      report(command + " is answered by " + event.command +
             " without the session of the message");
    return event.correlation == correlation_ && reply != Reply::none;
  }

  // Nothing if neither a role nor the description knows the event.
  std::optional<Reply> reply_of(const std::string& event) const {
    return find_reply(event, description_.roles, description_.events);
  }

  bool is_refusal(const std::string& event) const {
    return reply_of(event) == Reply::refusal;
  }

  // The events that would have ended the request, for the message.
  static std::string endings(const Role& role) {
    std::string names;
    for (const auto& event : role.events)
      if (event.reply != Reply::none)
        names += (names.empty() ? "" : ", ") + event.name;
    return names;
  }

  // How long an answer may take now.
  Milliseconds answer_time() const {
    const auto ready = started_ + options_.warm_up - Steady::now();
    return std::max(options_.deadline,
                    std::chrono::duration_cast<Milliseconds>(ready));
  }

  template <class Action>
  bool call(const std::string& what, Action action) {
    return call(what, action, options_.deadline);
  }

  // Calls into the plug-in. Returns false if it throws, and reports what took
  // much longer than allowed.
  template <class Action>
  bool call(const std::string& what, Action action, Milliseconds allowed) {
    if (options_.on_step)
      options_.on_step(what);
    // Real time is measured here: a call that takes long blocks its caller,
    // whatever the clock says.
    const auto begin = Steady::now();
    try {
      action();
    } catch (const std::exception& error) {
      report(what + ": it throws '" + error.what() + "'");
      return false;
    } catch (...) {
      report(what + ": it throws something");
      return false;
    }
    if (Steady::now() - begin > 2 * allowed)
      report(what + " takes too long");
    return true;
  }

  void report(std::string sentence) {
    findings_.push_back(std::move(sentence));
  }
  void report_once(const std::string& sentence) {
    if (std::ranges::find(findings_, sentence) == findings_.end())
      report(sentence);
  }

  const PluginDescription& description_;
  const TestOptions& options_;
  std::vector<std::string>& findings_;
  TestHost host_;
  std::unique_ptr<IPlugin> plugin_;
  Correlation correlation_ = 0;
  Steady::time_point started_{};
};

// Commands of the description itself are tested like those of a role.
void try_commands(TestedInstance& instance,
                  const PluginDescription& description) {
  for (const auto& name : description.roles)
    if (const auto* role = find_role(name))
      for (const auto& command : role->commands)
        instance.check_command(*role, command);
  Role own;
  own.events = description.events;
  for (const auto& command : description.commands)
    instance.check_command(own, command);
  instance.check_unknown_command();
}

} // namespace

// Three instances: one that is tested, a second one beside it (state that
// instances share by mistake shows here), and one after both have stopped (so
// do resources that were not released).
std::vector<std::string> conformance_errors(const PluginFactory& factory,
                                            const TestOptions& options) {
  auto findings = check_description(factory.description);
  {
    TestedInstance first(factory, options, findings);
    if (!first.start())
      return findings;
    first.check_kind();
    TestedInstance beside(factory, options, findings);
    beside.start();
    try_commands(first, factory.description);
  }
  TestedInstance again(factory, options, findings);
  again.start();
  return findings;
}

} // namespace parlour
