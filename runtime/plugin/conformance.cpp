#include "runtime/plugin/conformance.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "runtime/base/replies.hpp"
#include "runtime/plugin/description_check.hpp"
#include "runtime/plugin/parameters.hpp"
#include "runtime/plugin/trial_host.hpp"

namespace parlour {

namespace {

constexpr const char* trial_session = "trial";
constexpr const char* unknown_command = "NoSuchCommand";

// One instance on trial.
class Trial {
public:
  Trial(const PluginFactory& factory, const TrialTerms& terms,
        std::vector<std::string>& findings)
      : description_(factory.description), terms_(terms), findings_(findings) {
    host_.data = terms.data_folder;
    host_.application = terms.application_folder;
    call("making it", [&] { plugin_ = factory.create(); });
    if (!plugin_)
      report("its factory makes nothing");
  }
  ~Trial() {
    if (plugin_)
      call("stop", [&] { plugin_->stop(); });
  }

  bool start() {
    Expected<void> started = fail(ErrorKind::settings, "");
    if (plugin_ &&
        call("start",
             [&] { started = plugin_->start(host_, terms_.options); }) &&
        !started)
      report("it does not start: " + started.error().message);
    return started.has_value();
  }

  void check_kind() {
    const bool is = dynamic_cast<const InlinePlugin*>(plugin_.get()) != nullptr;
    if (description_.is_inline && !is)
      report("it is described as inline, but does not derive from "
             "InlinePlugin");
  }

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
  // Without its parameters.
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

  // The event that ends the request; empty where none comes in time.
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
    if (is_answered)
      call(command, [&] { host_.wait(answered, terms_.deadline); });
    else
      answered();
    return answer;
  }

  // True where it ends the request that was made last.
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

  // Nothing where nobody says what the event is.
  std::optional<Reply> reply_of(const std::string& event) const {
    return find_reply(event, description_.roles, description_.events);
  }

  bool is_refusal(const std::string& event) const {
    return reply_of(event) == Reply::refusal;
  }

  static std::string endings(const Role& role) {
    std::string names;
    for (const auto& event : role.events)
      if (event.reply != Reply::none)
        names += (names.empty() ? "" : ", ") + event.name;
    return names;
  }

  // Calls the plug-in; false where it throws.
  template <class Action>
  bool call(const std::string& what, Action action) {
    if (terms_.on_step)
      terms_.on_step(what);
    const auto begin = std::chrono::steady_clock::now();
    try {
      action();
    } catch (const std::exception& error) {
      report(what + ": it throws '" + error.what() + "'");
      return false;
    } catch (...) {
      report(what + ": it throws something");
      return false;
    }
    if (std::chrono::steady_clock::now() - begin > 2 * terms_.deadline)
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
  const TrialTerms& terms_;
  std::vector<std::string>& findings_;
  TrialHost host_;
  std::unique_ptr<IPlugin> plugin_;
  Correlation correlation_ = 0;
};

void try_commands(Trial& trial, const PluginDescription& description) {
  for (const auto& name : description.roles)
    if (const auto* role = find_role(name))
      for (const auto& command : role->commands)
        trial.check_command(*role, command);
  Role own;
  own.events = description.events;
  for (const auto& command : description.commands)
    trial.check_command(own, command);
  trial.check_unknown_command();
}

} // namespace

std::vector<std::string> nonconformities(const PluginFactory& factory,
                                         const TrialTerms& terms) {
  auto findings = check_description(factory.description);
  {
    Trial first(factory, terms, findings);
    if (!first.start())
      return findings;
    first.check_kind();
    Trial beside(factory, terms, findings);
    beside.start();
    try_commands(first, factory.description);
  }
  Trial again(factory, terms, findings);
  again.start();
  return findings;
}

} // namespace parlour
