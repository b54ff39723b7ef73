// soak_agent PORT MESSAGES: the agent's side of the soak test in C++, a plug-in
// that runs as `parlour agent` runs it. It sends the numbers from 1 to
// MESSAGES, takes as many from the platform, and prints as JSON what has become
// of them.
#include <cstdlib>
#include <iostream>
#include <optional>

#include <nlohmann/json.hpp>

#include "adapters/agents/client/plugin_agent.hpp"
#include "tests/soak/agents/numbers.hpp"

namespace {

using namespace parlour;
using namespace parlour::adapters::agents;

class Counter : public IPlugin {
public:
  Counter(std::uint64_t total, std::function<void()> stop)
      : total_(total), tally_(total), stop_(std::move(stop)) {}

protected:
  Expected<void> on_start(const Options&) override {
    send_more();
    return {};
  }

  void on_message(const Message& message) override {
    const auto number = std::stoull(message.params.at(0).text());
    if (message.command == "Stop")
      return end();
    if (message.command == "Confirm")
      confirmed_ = std::max<std::uint64_t>(confirmed_, number);
    else
      take(number, message.params.at(1));
    send_more();
  }

private:
  void take(std::uint64_t number, const Value& value) {
    if (const auto* binary = value.if_binary()) {
      const auto* first = reinterpret_cast<const char*>(binary->bytes.data());
      tally_.take(number, {first, binary->bytes.size()});
    } else {
      tally_.take(number, value.text());
    }
    if (tally_.count % soak::confirm_every == 0 || tally_.is_complete())
      fire_event("Confirm", {std::to_string(tally_.count)});
  }

  void send_more() {
    for (; next_ <= total_ && next_ <= confirmed_ + soak::window; ++next_)
      fire_event("Number", {std::to_string(next_), filler_of(next_)});
  }

  static Value filler_of(std::uint64_t number) {
    auto text = soak::filler(number);
    if (!soak::is_binary(number))
      return text;
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return Binary{"text/plain", {first, first + text.size()}};
  }

  void end() {
    const nlohmann::json figures = {{"received", tally_.count},
                                    {"missing", total_ - tally_.count},
                                    {"duplicates", tally_.duplicates},
                                    {"altered", tally_.altered},
                                    {"out_of_order", tally_.out_of_order}};
    std::cout << figures << std::endl;
    stop_();
  }

  const std::uint64_t total_;
  soak::Tally tally_;
  const std::function<void()> stop_;
  std::uint64_t next_ = 1;
  std::uint64_t confirmed_ = 0;
};

} // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "soak_agent PORT MESSAGES\n";
    return EXIT_FAILURE;
  }
  std::optional<PluginAgent> agent;
  PluginAgentOrder order;
  order.name = "Robot";
  order.address = {"127.0.0.1", arguments[1], false, ""};
  order.factory.create = [&, total = std::stoull(arguments[2])] {
    return std::make_unique<Counter>(total, [&] { agent->stop(); });
  };
  order.log = [](const std::string& line) { std::cerr << line << '\n'; };
  agent.emplace(std::move(order));
  if (const auto ran = agent->run(); !ran) {
    std::cerr << ran.error().message << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
