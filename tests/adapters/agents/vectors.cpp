#include "tests/adapters/agents/vectors.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "tests/support/paths.hpp"

namespace parlour::adapters::agents {
namespace {

using Json = nlohmann::json;

void read(const Json& described, const char* key,
          std::optional<std::uint64_t>& number) {
  if (described.contains(key))
    number = described[key].get<std::uint64_t>();
}

std::string bytes_of(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

MessageKind kind_named(const std::string& name) {
  for (int kind = 0; kind < 8; ++kind)
    if (name_of(static_cast<MessageKind>(kind)) == name)
      return static_cast<MessageKind>(kind);
  ADD_FAILURE() << "no kind " << name;
  return MessageKind::text;
}

} // namespace

const Json& vectors() {
  static const auto read = [] {
    std::ifstream file(
        test::source_path("adapters/agents/vectors/messages.json"));
    return Json::parse(file);
  }();
  return read;
}

AgentMessage message_in(const Json& described) {
  AgentMessage message;
  message.kind = kind_named(described["kind"]);
  message.session = described.value("session", "");
  message.sinks = described.value("sinks", std::vector<std::string>());
  read(described, "number", message.number);
  read(described, "acknowledged", message.acknowledged);
  read(described, "window", message.window);
  read(described, "correlation", message.correlation);
  read(described, "deadline", message.deadline);
  read(described, "time", message.time);
  message.gap = described.value("gap", false);
  message.component = described.value("component", "");
  message.command = described.value("command", "");
  message.parameters =
      described.value("parameters", std::vector<std::string>());
  if (described.contains("payload")) {
    const auto& payload = described["payload"];
    message.payload.emplace();
    message.payload->format = payload["format"];
    message.payload->bytes = bytes_of(payload["hex"]);
    read(payload, "position", message.payload->position);
  }
  return message;
}

std::string line_in(const Json& example) {
  const std::string line = example["line"];
  return line.find('\n') == std::string::npos ? line + '\n' : line;
}

} // namespace parlour::adapters::agents
