#include "runtime/plugin/plugin.hpp"

#include <utility>

namespace parlour {

Expected<void> IPlugin::start(PluginHost& host, const Options& options) {
  host_ = &host;
  return on_start(options);
}

void IPlugin::receive(const Message& message) {
  struct Restore {
    const Message*& slot;
    const Message* previous;
    ~Restore() {
      slot = previous;
    }
  } restore{current_, std::exchange(current_, &message)};
  on_message(message);
}

void IPlugin::fire_event(std::string command, std::vector<Value> params) {
  answer(current_ ? *current_ : Message{}, std::move(command),
         std::move(params));
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

void InlinePlugin::on_message(const Message& message) {
  for (auto& answer : answers(message))
    fire_event(std::move(answer.command), std::move(answer.params));
}

} // namespace parlour
