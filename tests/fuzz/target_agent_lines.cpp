// Any bytes as an agent's TCP connection: the reader, and the exchange behind
// it. What is accepted must be written as something that reads the same.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "adapters/agents/delivery/exchange.hpp"
#include "adapters/agents/wire/parameters.hpp"
#include "adapters/agents/wire/text_line.hpp"

namespace {

using namespace parlour::adapters::agents;

class World : public AgentExchange::Connections,
              public AgentExchange::Platform {
public:
  void write(ConnectionId, const AgentMessage& message) override {
    if (!line_of(message))
      std::abort(); // the platform writes what can be written
  }
  void pack(ConnectionId) override {}
  void close(ConnectionId) override {
    closed = true;
  }
  void online(const Hello&) override {}
  void offline(const std::string&) override {}
  std::optional<WireError> received(const std::string&,
                                    AgentMessage&& message) override {
    const auto made = message_from_agent(message, true);
    return made ? std::nullopt : std::optional(made.error());
  }
  void refused(const std::string&, const AgentMessage&,
               const parlour::Error&) override {}
  void mistake(const std::string&, const WireError&) override {}

  bool closed = false;
};

void check(const AgentMessage& message) {
  const auto line = line_of(message);
  if (!line)
    std::abort();
  LineReader reader;
  reader.add(*line);
  const auto again = reader.next();
  if (!again || !*again || **again != message)
    std::abort();
}

} // namespace

// The first byte says in which pieces the others arrive.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size == 0)
    return 0;
  const std::size_t piece = data[0] + 1U;
  std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  World world;
  AgentExchange exchange({{"Robot", "", ""}}, "bb", world, world);
  exchange.opened(1, {"peer", {}, false}, 0);
  LineReader reader;
  parlour::Timestamp now = 0;
  while (!bytes.empty() && !world.closed) {
    const auto taken = std::min(piece, bytes.size());
    reader.add(bytes.substr(0, taken));
    bytes.remove_prefix(taken);
    while (!world.closed) {
      auto message = reader.next();
      if (!message)
        break;
      if (*message)
        check(**message);
      exchange.arrived(1, std::move(*message), ++now);
    }
    exchange.tick(now += 10);
  }
  return 0;
}
