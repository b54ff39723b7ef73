// An exchange of agents, and the world around it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "adapters/agents/delivery/exchange.hpp"
#include "adapters/agents/wire/text_line.hpp"

namespace parlour::adapters::agents {

// What the exchange wants, noted down as "1< line" (written to connection 1),
// "1 closed", and of the platform "Robot online", "Robot: Arrived(lobby)".
class World : public AgentExchange::Connections,
              public AgentExchange::Platform {
public:
  void write(ConnectionId id, const AgentMessage& message) override {
    auto line = line_of(message).value();
    line.pop_back();
    notes.push_back(std::to_string(id) + "< " + line);
  }
  void pack(ConnectionId id) override {
    notes.push_back(std::to_string(id) + " packed");
  }
  void close(ConnectionId id) override {
    notes.push_back(std::to_string(id) + " closed");
  }
  void online(const Hello& hello) override {
    notes.push_back(hello.name + " online");
  }
  void offline(const std::string& agent) override {
    notes.push_back(agent + " offline");
  }
  std::optional<WireError> received(const std::string& agent,
                                    AgentMessage&& message) override {
    if (message.command == "Unwanted")
      return WireError{WireErrorKind::refused, "nobody takes it"};
    if (message.command == "Garbled")
      return WireError{WireErrorKind::malformed, "it is no JSON"};
    notes.push_back(agent + ": " + message.command);
    return {};
  }
  void refused(const std::string& agent, const AgentMessage& message,
               const Error& error) override {
    notes.push_back(agent + ": " + message.command + " given up, " +
                    std::string(name_of(error.kind)));
  }
  void mistake(const std::string& peer, const WireError& error) override {
    mistakes.push_back(peer + ": " + std::string(name_of(error.kind)));
  }

  std::vector<std::string> take() {
    return std::exchange(notes, {});
  }

  std::vector<std::string> notes;
  std::vector<std::string> mistakes;
};

class AgentExchangeTest : public testing::Test {
protected:
  void open(ConnectionId id, std::optional<std::string> key = {},
            bool is_remote = false) {
    exchange.opened(
        id, {"peer" + std::to_string(id), std::move(key), is_remote}, now);
  }
  void say(ConnectionId id, const std::string& line) {
    LineReader reader;
    reader.add(line + '\n');
    exchange.arrived(id, std::move(*reader.next()), now);
  }
  void connect(ConnectionId id) {
    open(id);
    say(id, "hello,,Robot,Hello,incarnation=aa");
    world.take();
  }
  static AgentMessage command(std::string what) {
    AgentMessage message;
    message.component = "Robot";
    message.command = std::move(what);
    return message;
  }

  Timestamp now = 1000;
  World world;
  AgentExchange exchange{{{"Robot", "", ""},
                          {"Arm", "secret", ""},
                          {"Eye", "", "key"},
                          {"Both", "t", "k"}},
                         "bb",
                         world,
                         world};
};

} // namespace parlour::adapters::agents
