// conformance_agent ADDRESS [fires]: the agent of
// adapters/agents/vectors/exchanges.json in C++, a plug-in that runs as
// `parlour agent` runs it. ADDRESS is lines://127.0.0.1:PORT.
#include <algorithm>
#include <cctype>
#include <iostream>
#include <optional>

#include "adapters/agents/client/plugin_agent.hpp"

namespace {

using namespace parlour;
using namespace parlour::adapters::agents;

class Conforming : public IPlugin {
public:
  Conforming(bool fires, std::function<void()> stop)
      : fires_(fires), stop_(std::move(stop)) {}

protected:
  Expected<void> on_start(const Options&) override {
    if (fires_)
      fire_event("Started");
    return {};
  }

  void on_message(const Message& message) override {
    if (message.command == "Echo")
      fire_event("Echoed", message.params);
    else if (message.command == "Count")
      count(std::stoi(message.params.at(0).text()));
    else if (message.command == "Ask")
      ask(message);
    else if (message.command == "Stop")
      stop_();
  }

private:
  void count(int steps) {
    for (int number = 1; number <= steps; ++number)
      fire_event("Step", {std::to_string(number)});
  }

  void ask(const Message& message) {
    Message request;
    request.sinks = {message.params.at(0).text()};
    request.command = message.params.at(1).text();
    host().ask(std::move(request),
               Milliseconds(std::stoi(message.params.at(2).text())),
               [this](const Expected<Message>& outcome) {
                 fire_event("Outcome", values_of(outcome));
               });
  }

  static std::vector<Value> values_of(const Expected<Message>& outcome) {
    if (!outcome) {
      std::string kind(name_of(outcome.error().kind));
      std::ranges::transform(kind, kind.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
      });
      return {kind};
    }
    std::vector<Value> values = {outcome->command};
    values.insert(values.end(), outcome->params.begin(), outcome->params.end());
    return values;
  }

  const bool fires_;
  const std::function<void()> stop_;
};

} // namespace

int main(int count, char** arguments) {
  const std::string address = count > 1 ? arguments[1] : "";
  std::optional<PluginAgent> agent;
  PluginAgentOrder order;
  order.name = "Robot";
  order.address = {"127.0.0.1", address.substr(address.rfind(':') + 1), false,
                   ""};
  order.factory.description.roles = {"Robot"};
  order.factory.create = [&] {
    return std::make_unique<Conforming>(count > 2, [&] { agent->stop(); });
  };
  order.log = [](const std::string&) {};
  agent.emplace(std::move(order));
  const auto ran = agent->run();
  // The first word of the reason is the kind of the platform's error.
  std::cout << "ended "
            << (ran ? "stopped"
                    : ran.error().message.substr(0,
                                                 ran.error().message.find(':')))
            << std::endl;
}
