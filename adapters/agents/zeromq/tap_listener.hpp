// TapListener receives what a MessageTap publishes (adapters/agents/PROTOCOL.md
// 6), for `parlour tap`.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/agents/wire/agent_message.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

class TapListener {
public:
  // Connects to "tcp://127.0.0.1:5673", also before anybody publishes there,
  // and again whenever the connection is lost. It is given the messages whose
  // "source.command" begins with one of `beginnings`; all if there are none.
  // The error, of kind Settings, means that the address cannot be read.
  static Expected<std::unique_ptr<TapListener>>
  connect(const std::string& address,
          const std::vector<std::string>& beginnings);
  ~TapListener();

  // Waits for the next message, or for stop(): then there is none. The error
  // means that something else than a tap publishes there.
  std::optional<Read<AgentMessage>> next();
  // From any thread, also in a signal handler.
  void stop();

private:
  struct Socket;
  explicit TapListener(std::unique_ptr<Socket> socket);
  std::unique_ptr<Socket> socket_;
};

} // namespace parlour::adapters::agents
