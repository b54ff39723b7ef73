#include "runtime/plugin/plugin.hpp"

#include <utility>

#include "runtime/base/defaults.hpp"

namespace parlour {

Expected<void> IPlugin::start(PluginHost& host, const Options& options) {
  host_ = &host;
  return on_start(options);
}

void IPlugin::receive(const Message& message) {
  as_answer_to(message, [&] { on_message(message); });
}

void IPlugin::as_answer_to(const Message& earlier,
                           const std::function<void()>& action) {
  // Restores the previous message on return and when an exception passes, as
  // calls may be nested: a reaction may run within another message.
  struct Restore {
    const Message*& slot;
    const Message* previous;
    ~Restore() {
      slot = previous;
    }
  } restore{current_, std::exchange(current_, &earlier)};
  action();
}

Message IPlugin::current() const {
  return current_ ? *current_ : Message{};
}

void IPlugin::fire_event(std::string command, std::vector<Value> params) {
  answer(current(), std::move(command), std::move(params));
}

void IPlugin::answer(const Message& to, std::string command,
                     std::vector<Value> params) {
  Message event;
  event.command = std::move(command);
  event.params = std::move(params);
  event.session = to.session;
  event.correlation = to.correlation;
  host_->fire_event(std::move(event));
}

void IPlugin::send_message(Message message) {
  host_->send_message(std::move(message));
}

void IPlugin::ask(std::string module, std::string command,
                  std::vector<Value> params, PluginHost::Reaction reaction) {
  Message request;
  request.command = std::move(command);
  request.params = std::move(params);
  request.sinks = {std::move(module)};
  if (current_)
    request.session = current_->session;
  host_->ask(std::move(request), defaults::request_timeout,
             std::move(reaction));
}

void InlinePlugin::on_message(const Message& message) {
  for (auto& answer : answers(message))
    fire_event(std::move(answer.command), std::move(answer.params));
}

} // namespace parlour
